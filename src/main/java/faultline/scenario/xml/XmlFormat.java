package faultline.scenario.xml;

import javax.xml.validation.Schema;

/**
 * A file format that is read as a tree of elements.
 *
 * @param namespace of every element
 * @param rootElement the name of its root element
 * @param schemaFile the name of its schema, for messages
 * @param schema what a document is validated against
 */
public record XmlFormat(String namespace, String rootElement, String schemaFile, Schema schema) {

    /** Scenario files. */
    public static final XmlFormat SCENARIO =
            new XmlFormat(ScenarioSchema.NAMESPACE, "scenario", "scenario-1.xsd", ScenarioSchema.get());
}
