package faultline.scenario.xml;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;
import org.xml.sax.ext.DefaultHandler2;

/**
 * The comments of a file, so that saving does not lose what a person has written. A comment stays before the element
 * that follows it, wherever that element is written in its parent; if the element was removed, the comment moves to the
 * end of its parent. {@link ElementMatch} says how an element is found.
 */
public final class XmlComments {

    /** No comments. */
    public static final XmlComments NONE = new XmlComments(CommentedElement.document());

    private final CommentedElement document;

    private XmlComments(CommentedElement document) {
        this.document = document;
    }

    /**
     * {@return the comments of a scenario file, none if the file cannot be read} Slow: not for the event dispatch
     * thread.
     *
     * @param file the file
     */
    public static XmlComments read(Path file) {
        try {
            return read(XmlFile.readBytes(file, Allowed.SCENARIO_FILE.with()));
        } catch (ScenarioException unreadable) {
            return NONE;
        }
    }

    /**
     * {@return the comments of a scenario file with some bytes, none if they are not well-formed XML, or beyond the
     * limits of a scenario}
     *
     * @param bytes the content of the file
     */
    public static XmlComments read(byte[] bytes) {
        Collector collector = new Collector();
        try {
            XMLReader reader = XmlParser.newParser().getXMLReader();
            reader.setProperty("http://xml.org/sax/properties/lexical-handler", collector);
            reader.setContentHandler(collector);
            reader.setErrorHandler(collector);
            reader.parse(new InputSource(new ByteArrayInputStream(bytes)));
            return new XmlComments(collector.open.element());
        } catch (SAXException | IOException broken) {
            return NONE;
        }
    }

    /** Returns the document with its comments. */
    CommentedElement document() {
        return document;
    }

    /** Collects the elements with the comments before them. */
    private static final class Collector extends DefaultHandler2 {

        private final Deque<CommentedElement> open = new ArrayDeque<>(List.of(CommentedElement.document()));
        private final List<String> pending = new ArrayList<>();
        private int elementCount;

        @Override
        public void comment(char[] buffer, int start, int length) {
            pending.add(new String(buffer, start, length));
        }

        @Override
        public void startElement(String uri, String localName, String qName, Attributes attributes)
                throws SAXException {
            if (++elementCount > ScenarioLimits.MAX_ELEMENTS || open.size() > ScenarioLimits.MAX_DEPTH) {
                throw new SAXException("too many elements, or nested too deep");
            }
            Map<String, String> values = new HashMap<>();
            for (int i = 0; i < attributes.getLength(); i++) {
                values.put(attributes.getQName(i), attributes.getValue(i));
            }
            CommentedElement element = new CommentedElement(localName, values, pending);
            pending.clear();
            open.element().addChild(element);
            open.push(element);
        }

        @Override
        public void endElement(String uri, String localName, String qName) {
            open.pop().end(pending);
            pending.clear();
        }

        @Override
        public void endDocument() {
            open.element().end(pending);
        }
    }
}
