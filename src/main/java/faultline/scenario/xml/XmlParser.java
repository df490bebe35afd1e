package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;
import java.io.ByteArrayInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/**
 * Parses a file to a tree of elements, without document types, external resources and entity expansion. The parser's
 * own messages depend on the language of the machine and are never shown.
 */
public final class XmlParser {

    /** Where a file names its encoding, if it does. */
    private static final SourceLocation XML_DECLARATION = new SourceLocation(1, 1);

    private static final int EXCERPT_LENGTH = 40;

    private final byte[] bytes;
    private final Problems problems;
    private final XmlFormat format;
    private final XmlTreeBuilder tree;

    /**
     * Creates a parser of one file.
     *
     * @param bytes the content of the file
     * @param problems collects what is wrong
     * @param format the format of the file
     */
    public XmlParser(byte[] bytes, Problems problems, XmlFormat format) {
        this.bytes = bytes;
        this.problems = problems;
        this.format = format;
        this.tree = new XmlTreeBuilder(format.namespace());
    }

    /** {@return the root element; empty, with a problem, if the file is not well-formed or has another root} */
    public Optional<XmlElement> parse() {
        try {
            newParser().parse(new ByteArrayInputStream(bytes), tree);
            return tree.root();
        } catch (XmlTreeBuilder.LimitExceededException e) {
            problems.add(
                    tree.openElements().isEmpty()
                            ? SourceLocation.NONE
                            : tree.openElements().get(0).location(),
                    e.problem());
        } catch (SAXParseException e) {
            problems.add(new SourceLocation(e.getLineNumber(), e.getColumnNumber()), describe(e));
        } catch (UnsupportedEncodingException e) {
            problems.add(XML_DECLARATION, ProblemKind.ENCODING.with());
        } catch (CharConversionException e) {
            problems.add(SourceLocation.NONE, ProblemKind.ENCODING.with());
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

    private Message describe(SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        if (message.contains("disallow-doctype-decl")) {
            return ProblemKind.DOCTYPE.with();
        }
        if (e.getException() instanceof CharConversionException) {
            return ProblemKind.ENCODING.with();
        }
        if (message.startsWith("JAXP")) {
            return ProblemKind.PARSER_LIMIT.with();
        }
        if (tree.isEmpty() && looksLikeUtf16()) {
            return ProblemKind.ENCODING.with();
        }
        String before = excerpt(e);
        List<XmlElement> open = tree.openElements();
        if (open.isEmpty()) {
            return tree.root().isEmpty() ? describeNoXml(before) : describeMalformed(before);
        }
        String element = MessageText.oneLine(open.get(0).name());
        int line = open.get(0).location().line();
        return before.isEmpty()
                ? ProblemKind.MALFORMED_INSIDE.with(element, line)
                : ProblemKind.MALFORMED_AFTER_INSIDE.with(before, element, line);
    }

    /** Every second byte of the beginning is zero, or there is the mark of UTF-16. */
    private boolean looksLikeUtf16() {
        if (bytes.length < 4) {
            return false;
        }
        int mark = (bytes[0] & 0xff) << 8 | bytes[1] & 0xff;
        return mark == 0xfeff || mark == 0xfffe || mark == '<' || mark == '<' << 8;
    }

    private Message describeNoXml(String before) {
        return before.isEmpty()
                ? ProblemKind.NOT_XML.with(format.rootElement())
                : ProblemKind.NOT_XML_AFTER.with(format.rootElement(), before);
    }

    private static Message describeMalformed(String before) {
        return before.isEmpty() ? ProblemKind.MALFORMED.with() : ProblemKind.MALFORMED_AFTER.with(before);
    }

    /** Returns the text just before the place where the parser stopped; empty if there is none. */
    private String excerpt(SAXParseException e) {
        List<String> lines = new String(bytes, StandardCharsets.UTF_8)
                .lines()
                .limit(Math.max(0, e.getLineNumber()))
                .toList();
        if (lines.isEmpty() || lines.size() < e.getLineNumber()) {
            return "";
        }
        String line = lines.get(lines.size() - 1);
        int end = Math.max(0, Math.min(line.length(), e.getColumnNumber() - 1));
        String before = line.substring(Math.max(0, end - EXCERPT_LENGTH), end).strip();
        return before.isEmpty() ? "" : MessageText.excerpt((end > EXCERPT_LENGTH ? "..." : "") + before);
    }
}
