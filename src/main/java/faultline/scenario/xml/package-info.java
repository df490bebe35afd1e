/**
 * Scenario files. Reading has three steps: {@code XmlParser} builds a tree of elements with their locations,
 * {@code ScenarioReader} and the readers of the sections convert it to values, and all problems are reported together
 * in a {@link faultline.scenario.xml.ScenarioException}. {@code ScenarioReader} and {@code ScenarioWriter} are the
 * entry points. Safe on any thread.
 */
package faultline.scenario.xml;
