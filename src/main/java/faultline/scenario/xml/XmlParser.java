package faultline.scenario.xml;

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
import javax.xml.validation.Schema;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/**
 * Parses a file to its tree of elements: no document type, nothing fetched from outside, nothing expanded. The parser's
 * own texts depend on the language of the machine, so that none of them is shown.
 */
public final class XmlParser {

    private static final int EXCERPT_LENGTH = 40;
    private static final String ENCODING_PROBLEM =
            "the bytes are not text in the encoding that the file names, allowed is UTF-8";

    private final byte[] bytes;
    private final Problems problems;
    private final XmlFormat format;
    private final XmlTreeBuilder tree;

    /** Creates a parser of one file. */
    public XmlParser(byte[] bytes, Problems complaints, XmlFormat format) {
        this.bytes = bytes;
        this.problems = complaints;
        this.format = format;
        this.tree = new XmlTreeBuilder(format.namespace());
    }

    /** The root element; empty, with a complaint, where the file is no XML that we take. */
    public Optional<XmlElement> parse() {
        try {
            newParser(Optional.of(format.schema())).parse(new ByteArrayInputStream(bytes), tree);
            return tree.root();
        } catch (XmlTreeBuilder.LimitExceededException e) {
            problems.add(
                    tree.openElements().isEmpty()
                            ? SourceLocation.NONE
                            : tree.openElements().get(0).location(),
                    e.getMessage());
        } catch (SAXParseException e) {
            problems.add(new SourceLocation(e.getLineNumber(), e.getColumnNumber()), describe(e));
        } catch (CharConversionException | UnsupportedEncodingException e) {
            problems.add(SourceLocation.NONE, ENCODING_PROBLEM);
        } catch (SAXException | IOException e) {
            problems.add(SourceLocation.NONE, "the file cannot be read as XML");
        }
        return Optional.empty();
    }

    /** What the schema still minds in a file that we found nothing wrong with. */
    public void reportSchemaError() {
        tree.schemaError()
                .ifPresent(offence -> problems.add(
                        new SourceLocation(offence.getLineNumber(), offence.getColumnNumber()),
                        "this is not as the schema " + format.schemaFile() + " has it (rule " + schemaRule(offence)
                                + ")"));
    }

    /** The rule of the XML Schema standard that was broken; the parser puts it before its text in every language. */
    private static String schemaRule(SAXParseException offence) {
        return offence.getMessage().split(":", 2)[0];
    }

    /** A parser that takes the same documents, but holds them to no schema. */
    static SAXParser newNonValidatingParser() {
        return newParser(Optional.empty());
    }

    private static SAXParser newParser(Optional<Schema> schema) {
        try {
            SAXParserFactory factory = SAXParserFactory.newDefaultInstance();
            factory.setNamespaceAware(true);
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            factory.setSchema(schema.orElse(null));
            SAXParser parser = factory.newSAXParser();
            parser.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
            parser.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
            return parser;
        } catch (ParserConfigurationException | SAXException e) {
            throw new IllegalStateException("the JDK's XML parser lacks a feature that every JDK has", e);
        }
    }

    private String describe(SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        if (message.contains("disallow-doctype-decl")) {
            return "the file has a DOCTYPE, allowed is none";
        }
        if (e.getException() instanceof CharConversionException) {
            return ENCODING_PROBLEM;
        }
        if (message.startsWith("JAXP")) {
            return "the file goes beyond a limit of the XML parser";
        }
        if (tree.openElements().isEmpty() && tree.root().isEmpty()) {
            return "this is not XML, allowed is a document that begins with <" + format.rootElement() + ">"
                    + excerpt(e);
        }
        return "this is not well-formed XML" + excerpt(e) + enclosingElement(tree.openElements());
    }

    private static String enclosingElement(List<XmlElement> open) {
        return open.isEmpty()
                ? ""
                : ", inside <" + MessageText.oneLine(open.get(0).name()) + "> of line "
                        + open.get(0).location().line();
    }

    /** The text just before the place where the parser gave up. */
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
        return before.isEmpty() ? "" : ", after " + MessageText.quoted((end > EXCERPT_LENGTH ? "..." : "") + before);
    }
}
