/**
 * What all files of the program in XML share: {@code XmlParser} builds a tree of elements with their locations, an
 * {@code AttributeReader} converts attributes to values within limits, and all problems of a file are reported together
 * in a {@link faultline.scenario.xml.ScenarioException}. Knows no scenario. Safe on any thread.
 */
package faultline.scenario.xml;
