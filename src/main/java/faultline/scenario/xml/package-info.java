/**
 * Scenario files. Reading goes in three steps: {@code XmlParser} makes a tree of elements with their locations,
 * {@code ScenarioReader} and the readers of the sections make values of it, and all problems are reported together in a
 * {@link faultline.scenario.xml.ScenarioException}. {@link faultline.scenario.xml.ScenarioFiles} is the entry. Any
 * thread may call it.
 */
package faultline.scenario.xml;
