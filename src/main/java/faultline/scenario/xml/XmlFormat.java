package faultline.scenario.xml;

/**
 * A file format that is read as a tree of elements.
 *
 * @param namespace the namespace of every element
 * @param rootElement the name of its root element
 */
public record XmlFormat(String namespace, String rootElement) {

    /** Scenario files. */
    public static final XmlFormat SCENARIO = new XmlFormat("urn:faultline:scenario:1", "scenario");
}
