/**
 * Scenario files: XML, checked by a schema and then for sense, read to a {@link faultline.scenario.Scenario} and
 * written back; and running one headless, which is what a user's test calls. Reading goes in three steps:
 * {@code XmlParser} makes a tree of elements with their places, the readers of each section make values of it, and all
 * complaints come at once. Nothing here knows of windows; any thread may call it.
 */
package faultline.scenario;
