/**
 * What all files of the program in XML share: {@code XmlParser} builds a tree of elements with their locations, an
 * {@code AttributeReader} converts attributes to values within limits, and all problems of a file are reported together
 * in a {@link faultline.scenario.xml.ScenarioException}. Has the limits and sentences about scenarios that plans need,
 * too, but reads neither of them. Safe on any thread.
 */
package faultline.scenario.xml;
