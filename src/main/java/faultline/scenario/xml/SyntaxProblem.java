package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;
import java.io.CharConversionException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.xml.sax.SAXParseException;

/**
 * Describes why a file is not well-formed XML. The parser's own messages depend on the language of the machine and are
 * never shown.
 */
final class SyntaxProblem {

    /** The longest beginning of a file in which its encoding is looked for, bytes. */
    private static final int MAX_DECLARATION = 500;

    private static final Pattern DECLARATION = Pattern.compile("<\\?xml[^>]*\\sencoding\\s*=\\s*[\"']([^\"'>]+)");

    private final byte[] bytes;
    private final XmlFormat format;
    private final XmlParser tree;

    /** Creates a description of a file from its content and the part of its tree that was built. */
    SyntaxProblem(byte[] bytes, XmlFormat format, XmlParser tree) {
        this.bytes = bytes;
        this.format = format;
        this.tree = tree;
    }

    /** Returns what is wrong, with the text before it and the element that it is in. */
    Message describe(SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        if (message.contains("disallow-doctype-decl")) {
            return ProblemKind.DOCTYPE.with();
        }
        if (e.getException() instanceof CharConversionException) {
            return describeEncoding(bytes);
        }
        if (message.startsWith("JAXP")) {
            return ProblemKind.PARSER_LIMIT.with();
        }
        if (tree.isEmpty() && (looksLikeUtf16() || isInAnotherEncoding())) {
            return describeEncoding(bytes);
        }
        String before = excerpt(e);
        List<XmlElement> open = tree.openElements();
        if (open.isEmpty()) {
            return tree.root().map(root -> describeRest(root, before)).orElseGet(() -> describeBeginning(before));
        }
        String element = MessageText.oneLine(open.get(0).name());
        int line = open.get(0).location().line();
        return before.isEmpty()
                ? ProblemKind.MALFORMED_INSIDE.with(element, line)
                : ProblemKind.MALFORMED_AFTER_INSIDE.with(before, element, line);
    }

    /** Describes a file whose bytes are not text in its encoding. */
    static Message describeEncoding(byte[] bytes) {
        return namedEncoding(bytes).isEmpty() ? ProblemKind.NOT_UTF8.with() : ProblemKind.ENCODING.with();
    }

    /** Describes a file whose encoding the parser does not know. */
    static Message describeUnknownEncoding(byte[] bytes) {
        return namedEncoding(bytes)
                .map(name -> ProblemKind.UNKNOWN_ENCODING.with(MessageText.quoted(name)))
                .orElseGet(ProblemKind.NOT_UTF8::with);
    }

    /** Returns the encoding that the declaration at the beginning names, also if each letter has several bytes. */
    private static Optional<String> namedEncoding(byte[] bytes) {
        String beginning = new String(bytes, 0, Math.min(bytes.length, MAX_DECLARATION), StandardCharsets.ISO_8859_1);
        Matcher declaration = DECLARATION.matcher(beginning.replace("\0", ""));
        return declaration.find() ? Optional.of(declaration.group(1)) : Optional.empty();
    }

    /** Returns whether the declaration is in ASCII and names an encoding in which it would have other bytes. */
    private boolean isInAnotherEncoding() {
        byte[] ascii = "<?xml".getBytes(StandardCharsets.US_ASCII);
        return Arrays.equals(ascii, Arrays.copyOf(bytes, ascii.length))
                && namedEncoding(bytes)
                        .filter(SyntaxProblem::isSupported)
                        .filter(name -> !Arrays.equals(ascii, "<?xml".getBytes(Charset.forName(name))))
                        .isPresent();
    }

    private static boolean isSupported(String encoding) {
        try {
            return Charset.isSupported(encoding) && Charset.forName(encoding).canEncode();
        } catch (IllegalCharsetNameException e) {
            return false;
        }
    }

    private Message describeBeginning(String before) {
        return beginsRoot() ? describeMalformed(before) : describeNoXml(before);
    }

    /** Describes an error after the root element, where only comments and instructions are allowed. */
    private Message describeRest(XmlElement root, String before) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        int end = text.lastIndexOf("</");
        String rest = text.substring(text.indexOf('>', end) + 1).strip();
        return rest.startsWith("<!--") || rest.startsWith("<?")
                ? describeMalformed(before)
                : ProblemKind.AFTER_ROOT.with(MessageText.oneLine(root.name()));
    }

    /** Every second byte of the beginning is zero, or there is the mark of UTF-16. */
    private boolean looksLikeUtf16() {
        if (bytes.length < 4) {
            return false;
        }
        int mark = (bytes[0] & 0xff) << 8 | bytes[1] & 0xff;
        return mark == 0xfeff || mark == 0xfffe || mark == '<' || mark == '<' << 8;
    }

    /** Returns whether the file holds the beginning of the root element, whose start tag may be wrong. */
    private boolean beginsRoot() {
        return Pattern.compile("<([\\w.-]{1,100}:)?" + Pattern.quote(format.rootElement()) + "\\s")
                .matcher(new String(bytes, StandardCharsets.UTF_8))
                .find();
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
        String before = line.substring(Math.max(0, end - ScenarioLimits.EXCERPT_LENGTH), end)
                .strip();
        return before.isEmpty() ? "" : MessageText.excerpt((end > ScenarioLimits.EXCERPT_LENGTH ? "..." : "") + before);
    }
}
