package faultline.scenario;

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
 * The comments of a file that a person has written by hand, so that they outlive a save. Each stays before the element that it stands
 * before, wherever that is written; where it is written no more, the comment moves to the end of what it stood in.
 */
public final class Remarks {

    /** No comment at all. */
    public static final Remarks NONE = new Remarks(List.of());

    /**
     * One comment.
     *
     * @param number from 0, in the file's order
     * @param before the path of the element that follows it in the same parent; where none does, the parent's path and a slash
     * @param text all between the comment's marks
     */
    record Remark(int number, String before, String text) {
    }

    private final List<Remark> all;

    private Remarks(List<Remark> all) {
        this.all = List.copyOf(all);
    }

    /**
     * Those of a file.
     *
     * @param file a scenario file; slow, and for other threads than the event dispatch thread
     * @return none where the file cannot be read
     */
    public static Remarks of(Path file) {
        try {
            return of(ScenarioBytes.ofFile(file));
        } catch (ScenarioException unreadable) {
            return NONE;
        }
    }

    static Remarks of(byte[] bytes) {
        Collector collector = new Collector();
        try {
            XMLReader reader = XmlParsing.plainParser().getXMLReader();
            reader.setProperty("http://xml.org/sax/properties/lexical-handler", collector);
            reader.setContentHandler(collector);
            reader.setErrorHandler(collector);
            reader.parse(new InputSource(new ByteArrayInputStream(bytes)));
            return new Remarks(collector.found);
        } catch (SAXException | IOException broken) {
            return NONE;
        }
    }

    /** In the file's order. */
    List<Remark> all() {
        return all;
    }

    /** Collects comments, and gives each its element as soon as that begins. */
    private static final class Collector extends DefaultHandler2 {

        private final ElementPath path = new ElementPath();
        private final List<Remark> found = new ArrayList<>();
        private final List<String> waiting = new ArrayList<>();

        @Override
        public void comment(char[] buffer, int start, int length) {
            waiting.add(new String(buffer, start, length));
        }

        @Override
        public void startElement(String uri, String localName, String qName, Attributes attributes) {
            String id = attributes.getValue("id");
            path.enter(localName, id == null ? "" : id);
            settle(path.now());
        }

        @Override
        public void endElement(String uri, String localName, String qName) {
            settle(path.now() + "/");
            path.leave();
        }

        @Override
        public void endDocument() {
            settle("/");
        }

        private void settle(String before) {
            waiting.forEach(text -> found.add(new Remark(found.size(), before, text)));
            waiting.clear();
        }
    }
}
