package faultline.scenario.xml;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;
import org.xml.sax.ext.DefaultHandler2;

/**
 * The comments of a file, so that saving does not lose what a person has written. A comment stays before the element
 * that follows it, wherever that element is written; if the element was removed, the comment moves to the end of its
 * parent.
 */
public final class XmlComments {

    /** No comments. */
    public static final XmlComments NONE = new XmlComments(List.of());

    /**
     * The text of a comment, its index in the file, from 0, and the path of the next element in the same parent; if
     * there is none, the parent's path and a slash.
     */
    record XmlComment(int index, String anchor, String text) {}

    private final List<XmlComment> comments;

    private XmlComments(List<XmlComment> all) {
        this.comments = List.copyOf(all);
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
            return new XmlComments(collector.found);
        } catch (SAXException | IOException broken) {
            return NONE;
        }
    }

    /** Returns the comments in the order of the file. */
    List<XmlComment> comments() {
        return comments;
    }

    /** Collects comments and gives each its anchor when the next element begins. */
    private static final class Collector extends DefaultHandler2 {

        private final ElementPath path = new ElementPath();
        private final List<XmlComment> found = new ArrayList<>();
        private final List<String> pending = new ArrayList<>();
        private int elementCount;
        private int depth;

        @Override
        public void comment(char[] buffer, int start, int length) {
            pending.add(new String(buffer, start, length));
        }

        @Override
        public void startElement(String uri, String localName, String qName, Attributes attributes)
                throws SAXException {
            if (++elementCount > ScenarioLimits.MAX_ELEMENTS || ++depth > ScenarioLimits.MAX_DEPTH) {
                throw new SAXException("too many elements, or nested too deep");
            }
            String id = attributes.getValue("id");
            path.enter(localName, id == null ? "" : id);
            flushPending(path.current());
        }

        @Override
        public void endElement(String uri, String localName, String qName) {
            flushPending(path.current() + "/");
            path.leave();
            depth--;
        }

        @Override
        public void endDocument() {
            flushPending("/");
        }

        private void flushPending(String before) {
            pending.forEach(text -> found.add(new XmlComment(found.size(), before, text)));
            pending.clear();
        }
    }
}
