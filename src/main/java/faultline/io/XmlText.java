package faultline.io;

/** Converts text to characters that are allowed in XML 1.0. */
public final class XmlText {

    private XmlText() {}

    /**
     * {@return a text on one line, with single blanks, and without the characters that XML cannot hold}
     *
     * @param text the text
     */
    public static String oneLine(String text) {
        return isWords(text)
                ? text
                : replaceInvalid(text, ' ').replaceAll("\\s+", " ").strip();
    }

    /** Returns whether a text consists of ASCII words with single blanks between them. */
    private static boolean isWords(String text) {
        boolean blank = true;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c < ' ' || c > '~' || blank && c == ' ') {
                return false;
            }
            blank = c == ' ';
        }
        return !blank || text.isEmpty();
    }

    /**
     * {@return a text without the white space of XML around it; other blanks stay}
     *
     * @param text the text
     */
    public static String strip(String text) {
        int begin = 0;
        int end = text.length();
        while (begin < end && isBlank(text.charAt(begin))) {
            begin++;
        }
        while (end > begin && isBlank(text.charAt(end - 1))) {
            end--;
        }
        return text.substring(begin, end);
    }

    private static boolean isBlank(char c) {
        return c == ' ' || c == '\t' || c == '\n' || c == '\r';
    }

    /**
     * {@return a text for use between double quotes; reading it gives the same characters, including white space}
     *
     * @param text the text
     */
    public static String escapeAttribute(String text) {
        return escapeText(text)
                .replace("\"", "&quot;")
                .replace("\t", "&#9;")
                .replace("\n", "&#10;")
                .replace("\r", "&#13;");
    }

    /**
     * {@return a text for use inside an element} A character that XML cannot hold is replaced by a question mark.
     *
     * @param text the text
     */
    public static String escapeText(String text) {
        return replaceInvalid(text, '?')
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;");
    }

    /**
     * {@return whether XML 1.0 can hold every character of a text}
     *
     * @param text the text
     */
    public static boolean isValid(String text) {
        return text.codePoints().allMatch(XmlText::isXmlCharacter);
    }

    private static String replaceInvalid(String text, int other) {
        if (isSurelyValid(text)) {
            return text;
        }
        return text.codePoints()
                .map(c -> isXmlCharacter(c) ? c : other)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }

    /** Returns whether a text needs no look at surrogates and is valid, as nearly every one is; this is fast. */
    private static boolean isSurelyValid(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (Character.isSurrogate(c) || !isXmlCharacter(c)) {
                return false;
            }
        }
        return true;
    }

    /** Returns whether a character is one of production 2 of XML 1.0. */
    private static boolean isXmlCharacter(int c) {
        return c == '\t'
                || c == '\n'
                || c == '\r'
                || c >= 0x20 && c <= 0xD7FF
                || c >= 0xE000 && c <= 0xFFFD
                || c >= 0x10000;
    }
}
