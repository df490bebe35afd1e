package faultline.io;

/** Text as XML 1.0 can hold it. */
public final class XmlText {

    private XmlText() {}

    /** Text for people: on one line, single blanks, and without the characters that XML cannot hold. */
    public static String oneLine(String text) {
        return replaceInvalid(text, ' ').replaceAll("\\s+", " ").strip();
    }

    /** Text in double quotes in a file; reads back to the same characters, white space included. */
    public static String escapeAttribute(String text) {
        return escapeText(text)
                .replace("\"", "&quot;")
                .replace("\t", "&#9;")
                .replace("\n", "&#10;")
                .replace("\r", "&#13;");
    }

    /** Text inside an element. What XML cannot hold at all becomes a question mark. */
    public static String escapeText(String text) {
        return replaceInvalid(text, '?')
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;");
    }

    private static String replaceInvalid(String text, int other) {
        return text.codePoints()
                .map(c -> isXmlCharacter(c) ? c : other)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }

    /** The characters of XML 1.0, production 2. */
    private static boolean isXmlCharacter(int c) {
        return c == '\t'
                || c == '\n'
                || c == '\r'
                || c >= 0x20 && c <= 0xD7FF
                || c >= 0xE000 && c <= 0xFFFD
                || c >= 0x10000;
    }
}
