package faultline.scenario.xml;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.xml.sax.SAXException;

/**
 * Compares what a reader accepts with the schema of its files. The program itself does not validate against a schema,
 * because its readers refuse everything that the schema does not allow.
 */
public final class SchemaCheck {

    private final Schema schema;

    /** Compiles the schema of a resource. */
    public SchemaCheck(URL resource) {
        try {
            SchemaFactory factory = SchemaFactory.newDefaultInstance();
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            schema = factory.newSchema(resource);
        } catch (SAXException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns a check of scenario files. */
    public static SchemaCheck ofScenarios() {
        return new SchemaCheck(XmlFormat.class.getResource("scenario-1.xsd"));
    }

    /** Fails if the schema does not allow a file. */
    public void assertValid(byte[] file) {
        try {
            validate(file);
        } catch (SAXException e) {
            throw new AssertionError(e.getMessage() + "\n" + new String(file, StandardCharsets.UTF_8), e);
        }
    }

    public boolean isValid(String text) {
        try {
            validate(text.getBytes(StandardCharsets.UTF_8));
            return true;
        } catch (SAXException e) {
            return false;
        }
    }

    private void validate(byte[] file) throws SAXException {
        try {
            schema.newValidator().validate(new StreamSource(new ByteArrayInputStream(file)));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
