package faultline.scenario.xml;

import java.net.URL;
import javax.xml.XMLConstants;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.xml.sax.SAXException;

/** The schema of scenario files, compiled once and only when a file is read. */
public final class ScenarioSchema {

    /** The namespace of every element. */
    static final String NAMESPACE = "urn:faultline:scenario:1";

    private static final String RESOURCE = "scenario-1.xsd";

    private ScenarioSchema() {}

    static Schema get() {
        return Holder.SCHEMA;
    }

    private static final class Holder {
        private static final Schema SCHEMA = compile();

        private static Schema compile() {
            return ScenarioSchema.compile(ScenarioSchema.class.getResource(RESOURCE));
        }
    }

    /**
     * Compiles a schema that ships with the program.
     *
     * @param file the schema
     * @return the compiled schema
     */
    public static Schema compile(URL file) {
        try {
            SchemaFactory factory = SchemaFactory.newDefaultInstance();
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            return factory.newSchema(file);
        } catch (SAXException e) {
            throw new IllegalStateException("the schema in the jar is broken", e);
        }
    }
}
