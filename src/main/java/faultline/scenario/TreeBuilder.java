package faultline.scenario;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.ext.Attributes2;
import org.xml.sax.helpers.DefaultHandler;

/** Builds the tree of elements from one pass of the parser, and remembers the first thing that the schema took offence at. */
final class TreeBuilder extends DefaultHandler {

    /** Ends the pass because the file goes beyond a limit. */
    static final class TooMuch extends SAXException {

        private static final long serialVersionUID = 1L;

        TooMuch(String message) {
            super(message);
        }
    }

    /** An element whose end tag has not come yet. */
    private record Open(Node node, StringBuilder text) {
    }

    private static final Attributes2 NONE_GIVEN = new org.xml.sax.ext.Attributes2Impl();

    private final Deque<Open> open = new ArrayDeque<>();
    private Locator locator;
    private int elements;
    private Optional<Node> root = Optional.empty();
    private Optional<SAXParseException> offence = Optional.empty();

    @Override
    public void setDocumentLocator(Locator parserLocator) {
        locator = parserLocator;
    }

    @Override
    public void startElement(String uri, String localName, String qName, Attributes attributes) throws SAXException {
        if (++elements > Limits.MOST_ELEMENTS) {
            throw new TooMuch("the file has too many elements, allowed is " + Limits.MOST_ELEMENTS);
        }
        if (open.size() == Limits.DEEPEST) {
            throw new TooMuch("the elements are nested too deep, allowed is " + Limits.DEEPEST);
        }
        String name = uri.equals(ScenarioSchema.NAMESPACE) ? localName : foreign(uri, qName);
        open.push(new Open(new Node(name, place(), given(attributes), new ArrayList<>(), ""), new StringBuilder()));
    }

    /** An element outside of our namespace is shown with its own, so that it cannot pass for one of ours. */
    private static String foreign(String uri, String qName) {
        return qName + (uri.isEmpty() ? " xmlns=\"\"" : " xmlns=\"" + uri + "\"");
    }

    private static Map<String, String> given(Attributes attributes) {
        Attributes2 all = attributes instanceof Attributes2 detailed ? detailed : NONE_GIVEN;
        Map<String, String> given = new LinkedHashMap<>();
        for (int i = 0; i < all.getLength(); i++) {
            if (all.isSpecified(i)) {
                given.put(nameOf(all, i), all.getValue(i));
            }
        }
        return given;
    }

    private static String nameOf(Attributes attributes, int index) {
        boolean schemaInstance = attributes.getURI(index).equals("http://www.w3.org/2001/XMLSchema-instance");
        return schemaInstance ? "xsi:" + attributes.getLocalName(index) : attributes.getQName(index);
    }

    private Place place() {
        return new Place(locator.getLineNumber(), locator.getColumnNumber());
    }

    @Override
    public void characters(char[] buffer, int start, int length) {
        open.peek().text.append(buffer, start, length);
    }

    /** Under a schema the parser takes some text for white space that is none. */
    @Override
    public void ignorableWhitespace(char[] buffer, int start, int length) {
        characters(buffer, start, length);
    }

    @Override
    public void endElement(String uri, String localName, String qName) {
        Open done = open.pop();
        Node raw = done.node;
        Node node = new Node(raw.name(), raw.place(), raw.attributes(), raw.children(), done.text.toString());
        if (open.isEmpty()) {
            root = Optional.of(node);
        } else {
            open.peek().node.children().add(node);
        }
    }

    /** The schema's errors come here; the parser's own are fatal. */
    @Override
    public void error(SAXParseException exception) {
        offence = offence.isPresent() ? offence : Optional.of(exception);
    }

    @Override
    public void fatalError(SAXParseException exception) throws SAXException {
        throw exception;
    }

    Optional<Node> root() {
        return root;
    }

    /** What the schema complained of first. */
    Optional<SAXParseException> offence() {
        return offence;
    }

    /** The elements that are still open, the innermost first. */
    List<Node> openElements() {
        return open.stream().map(Open::node).toList();
    }
}
