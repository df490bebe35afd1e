package faultline.scenario.xml;

import faultline.io.Message;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.ext.Attributes2;
import org.xml.sax.helpers.DefaultHandler;

/** Builds the tree of elements from one pass of the parser. */
final class XmlTreeBuilder extends DefaultHandler {

    /** Ends the pass because the file exceeds a limit. */
    static final class LimitExceededException extends SAXException {

        private static final long serialVersionUID = 1L;

        private final transient Message problem;

        LimitExceededException(Message problem) {
            super(problem.toString());
            this.problem = problem;
        }

        Message problem() {
            return problem;
        }
    }

    /** An element whose end tag has not been read yet. Most have neither children nor text. */
    private static final class PendingElement {
        private final String name;
        private final SourceLocation location;
        private final Map<String, String> attributes;
        private List<XmlElement> children = List.of();
        private StringBuilder text;

        PendingElement(String name, SourceLocation location, Map<String, String> attributes) {
            this.name = name;
            this.location = location;
            this.attributes = attributes;
        }

        void addChild(XmlElement child) {
            if (children.isEmpty()) {
                children = new ArrayList<>();
            }
            children.add(child);
        }

        void addText(char[] buffer, int start, int length) {
            if (text == null) {
                text = new StringBuilder();
            }
            text.append(buffer, start, length);
        }

        XmlElement toElement() {
            return new XmlElement(name, location, attributes, children, text == null ? "" : text.toString());
        }
    }

    private static final Attributes2 NO_ATTRIBUTES = new org.xml.sax.ext.Attributes2Impl();

    private final Deque<PendingElement> pendingElements = new ArrayDeque<>();
    private final String namespace;
    private Locator locator;
    private int elementCount;
    private XmlElement root;

    /** Creates a builder for documents whose elements are in a namespace. */
    XmlTreeBuilder(String namespace) {
        this.namespace = namespace;
    }

    @Override
    public void setDocumentLocator(Locator parserLocator) {
        locator = parserLocator;
    }

    @Override
    public void startElement(String uri, String localName, String qName, Attributes attributes) throws SAXException {
        if (++elementCount > ScenarioLimits.MAX_ELEMENTS) {
            throw new LimitExceededException(ProblemKind.TOO_MANY_ELEMENTS.with(ScenarioLimits.MAX_ELEMENTS));
        }
        if (pendingElements.size() == ScenarioLimits.MAX_DEPTH) {
            throw new LimitExceededException(ProblemKind.TOO_DEEP.with(ScenarioLimits.MAX_DEPTH));
        }
        String name = uri.equals(namespace) ? localName : foreignName(uri, qName);
        pendingElements.push(new PendingElement(name, location(), specifiedAttributes(attributes)));
    }

    /** Returns a name with its namespace, so that an element of another namespace cannot pass for one of ours. */
    private static String foreignName(String uri, String qName) {
        return qName + (uri.isEmpty() ? " xmlns=\"\"" : " xmlns=\"" + uri + "\"");
    }

    private static Map<String, String> specifiedAttributes(Attributes attributes) {
        Attributes2 all = attributes instanceof Attributes2 detailed ? detailed : NO_ATTRIBUTES;
        List<String> names = new ArrayList<>(all.getLength());
        List<String> values = new ArrayList<>(all.getLength());
        for (int i = 0; i < all.getLength(); i++) {
            if (all.isSpecified(i)) {
                names.add(attributeName(all, i));
                values.add(all.getValue(i));
            }
        }
        return new XmlAttributes(names, values);
    }

    private static String attributeName(Attributes attributes, int index) {
        String uri = attributes.getURI(index);
        if (uri.equals("http://www.w3.org/2001/XMLSchema-instance")) {
            return "xsi:" + attributes.getLocalName(index);
        }
        String name = attributes.getQName(index);
        return name.startsWith("xsi:") ? foreignName(uri, name) : name;
    }

    private SourceLocation location() {
        return new SourceLocation(locator.getLineNumber(), locator.getColumnNumber());
    }

    @Override
    public void characters(char[] buffer, int start, int length) {
        pendingElements.peek().addText(buffer, start, length);
    }

    @Override
    public void endElement(String uri, String localName, String qName) {
        XmlElement node = pendingElements.pop().toElement();
        if (pendingElements.isEmpty()) {
            root = node;
        } else {
            pendingElements.peek().addChild(node);
        }
    }

    @Override
    public void fatalError(SAXParseException exception) throws SAXException {
        throw exception;
    }

    /** Returns whether no element has begun. */
    boolean isEmpty() {
        return elementCount == 0;
    }

    Optional<XmlElement> root() {
        return Optional.ofNullable(root);
    }

    /** Returns the elements that are still open, the innermost first. */
    List<XmlElement> openElements() {
        return pendingElements.stream().map(PendingElement::toElement).toList();
    }
}
