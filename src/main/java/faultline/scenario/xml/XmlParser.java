package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;
import java.io.ByteArrayInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UnsupportedEncodingException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.ext.Attributes2;
import org.xml.sax.ext.Attributes2Impl;
import org.xml.sax.helpers.DefaultHandler;

/** Parses a file to a tree of elements, without document types, external resources and entity expansion. */
final class XmlParser extends DefaultHandler {

    /** Ends the pass because the file exceeds a limit. */
    private static final class LimitExceededException extends SAXException {

        private static final long serialVersionUID = 1L;

        private final transient Message problem;

        LimitExceededException(Message problem) {
            super(problem.toString());
            this.problem = problem;
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

    /** The place of the declaration of a file's encoding. */
    private static final SourceLocation XML_DECLARATION = new SourceLocation(1, 1);

    /**
     * The longest namespace in a name, in {@code char} values. Messages show no more, and a file has very many names.
     */
    private static final int MAX_NAMESPACE_LENGTH = 60;

    private static final Attributes2 NO_ATTRIBUTES = new Attributes2Impl();

    private final byte[] bytes;
    private final XmlFormat format;
    private final Deque<PendingElement> pendingElements = new ArrayDeque<>();
    private Locator locator;
    private int elementCount;
    private XmlElement root;

    /** Creates a parser of one file of a format. */
    XmlParser(byte[] bytes, XmlFormat format) {
        this.bytes = bytes;
        this.format = format;
    }

    /** Returns the root element; empty, with a problem, if the file is not well-formed. */
    Optional<XmlElement> parse(Problems problems) {
        try {
            newParser().parse(new ByteArrayInputStream(bytes), this);
            return root();
        } catch (LimitExceededException e) {
            List<XmlElement> open = openElements();
            problems.add(open.isEmpty() ? SourceLocation.NONE : open.get(0).location(), e.problem);
        } catch (SAXParseException e) {
            problems.add(
                    new SourceLocation(e.getLineNumber(), e.getColumnNumber()),
                    new SyntaxProblem(bytes, format, this).describe(e));
        } catch (UnsupportedEncodingException e) {
            problems.add(XML_DECLARATION, SyntaxProblem.describeUnknownEncoding(bytes));
        } catch (CharConversionException e) {
            problems.add(SourceLocation.NONE, SyntaxProblem.describeEncoding(bytes));
        } catch (SAXException | IOException e) {
            problems.add(SourceLocation.NONE, ProblemKind.UNREADABLE_XML.with());
        }
        return Optional.empty();
    }

    /** Returns a parser that reads neither document types nor anything outside the file. */
    static SAXParser newParser() {
        try {
            SAXParserFactory factory = SAXParserFactory.newDefaultInstance();
            factory.setNamespaceAware(true);
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            SAXParser parser = factory.newSAXParser();
            parser.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
            parser.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
            return parser;
        } catch (ParserConfigurationException | SAXException e) {
            throw new IllegalStateException("the JDK's XML parser lacks a feature that every JDK has", e);
        }
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
        String name = uri.equals(format.namespace()) ? localName : foreignName(uri, qName);
        pendingElements.push(new PendingElement(name, location(), specifiedAttributes(attributes)));
    }

    /**
     * Returns a name with the start of its namespace, so that an element of another namespace cannot pass for one of
     * ours.
     */
    private static String foreignName(String uri, String qName) {
        return qName + " xmlns=\"" + MessageText.shortened(uri, MAX_NAMESPACE_LENGTH) + "\"";
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
