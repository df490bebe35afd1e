package faultline.io;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads JSON (RFC 8259) in time linear in the text. Objects become {@link Map}s in the order of the text, arrays
 * {@link List}s, strings {@link String}s, numbers {@link Double}s (or {@link Long}s, if they are whole and a double
 * would round them, or other {@link Number}s that have the text of the number, if they are beyond all doubles, or whole
 * and beyond all longs), truth values {@link Boolean}s, and {@code null} the constant {@link #NULL}.
 */
public final class JsonParser {

    /** Stands for {@code null} in maps and lists. */
    public static final Object NULL = new Object() {
        @Override
        public String toString() {
            return "null";
        }
    };

    /** Texts that some languages write for numbers that JSON does not have. */
    private static final List<String> NOT_FINITE = List.of("NaN", "Infinity");

    private static final int MAX_DEPTH = 64;

    /** From here on a double cannot hold every whole number. */
    private static final double FIRST_ROUNDED = 1L << 53;

    private final String text;
    private int next;
    private int depth;

    private JsonParser(String text) {
        this.text = text;
    }

    /**
     * {@return the value of a text that is one, with nothing but blanks around it}
     *
     * @param text a JSON text
     * @throws JsonException if the text is no JSON, names a member twice, or is nested too deeply
     */
    public static Object parse(String text) throws JsonException {
        JsonParser parser = new JsonParser(text);
        Object value = parser.parseValue();
        parser.skipBlanks();
        if (parser.next < text.length()) {
            throw parser.problem("there is text after the value");
        }
        return value;
    }

    private Object parseValue() throws JsonException {
        skipBlanks();
        char c = peek();
        if (c == '{') {
            return parseObject();
        }
        if (c == '[') {
            return parseArray();
        }
        if (c == '"') {
            return parseString();
        }
        if (c == '-' || c >= '0' && c <= '9') {
            return parseNumber();
        }
        return parseWord();
    }

    private Object parseWord() throws JsonException {
        if (text.startsWith("true", next)) {
            next += 4;
            return Boolean.TRUE;
        }
        if (text.startsWith("false", next)) {
            next += 5;
            return Boolean.FALSE;
        }
        if (text.startsWith("null", next)) {
            next += 4;
            return NULL;
        }
        for (String word : NOT_FINITE) {
            if (text.startsWith(word, next)) {
                throw problem(word + " is no number in JSON");
            }
        }
        if (text.startsWith("\uFEFF", next)) {
            throw problem("there is a byte order mark");
        }
        throw problem(next == text.length() ? "the text ends before a value" : "there is no value");
    }

    private Map<String, Object> parseObject() throws JsonException {
        enter();
        Map<String, Object> members = new LinkedHashMap<>();
        if (isNext('}')) {
            depth--;
            return members;
        }
        do {
            skipBlanks();
            if (peek() != '"') {
                throw problem("a member's name is missing");
            }
            String name = parseString();
            if (!isNext(':')) {
                throw problem("a colon is missing");
            }
            if (members.put(name, parseValue()) != null) {
                throw problem("a member is given twice");
            }
        } while (isNext(','));
        leave('}');
        return members;
    }

    private List<Object> parseArray() throws JsonException {
        enter();
        List<Object> values = new ArrayList<>();
        if (isNext(']')) {
            depth--;
            return values;
        }
        do {
            values.add(parseValue());
        } while (isNext(','));
        leave(']');
        return values;
    }

    private void enter() throws JsonException {
        next++;
        if (++depth > MAX_DEPTH) {
            throw problem("values are nested more than " + MAX_DEPTH + " deep");
        }
    }

    private void leave(char end) throws JsonException {
        if (!isNext(end)) {
            throw problem("a comma or " + end + " is missing");
        }
        depth--;
    }

    private String parseString() throws JsonException {
        int begin = ++next;
        while (next < text.length()
                && text.charAt(next) != '"'
                && text.charAt(next) != '\\'
                && text.charAt(next) >= ' ') {
            next++;
        }
        if (next < text.length() && text.charAt(next) == '"') {
            return text.substring(begin, next++);
        }
        StringBuilder string = new StringBuilder().append(text, begin, next);
        while (peek() != '"') {
            char c = text.charAt(next++);
            if (c < ' ') {
                throw problem("a string holds a control character");
            }
            string.append(c == '\\' ? parseEscape() : c);
        }
        next++;
        return string.toString();
    }

    private char parseEscape() throws JsonException {
        char c = peek();
        next++;
        switch (c) {
            case '"', '\\', '/':
                return c;
            case 'b':
                return '\b';
            case 'f':
                return '\f';
            case 'n':
                return '\n';
            case 'r':
                return '\r';
            case 't':
                return '\t';
            case 'u':
                return parseCodeUnit();
            default:
                throw problem("there is no such escape");
        }
    }

    private char parseCodeUnit() throws JsonException {
        int unit = 0;
        for (int i = 0; i < 4; i++) {
            // The digits of other scripts are digits to Java, but not to JSON.
            int digit = peek() < 128 ? Character.digit(peek(), 16) : -1;
            if (digit < 0) {
                throw problem("an escape needs four hexadecimal digits");
            }
            unit = 16 * unit + digit;
            next++;
        }
        return (char) unit;
    }

    private Number parseNumber() throws JsonException {
        int begin = next;
        if (peek() == '-') {
            next++;
            if (text.startsWith("Infinity", next)) {
                throw problem("-Infinity is no number in JSON");
            }
        }
        int integer = next;
        skipDigits();
        boolean leadingZero = next > integer + 1 && text.charAt(integer) == '0';
        if (next < text.length() && text.charAt(next) == '.') {
            next++;
            skipDigits();
        }
        if (next < text.length() && (text.charAt(next) == 'e' || text.charAt(next) == 'E')) {
            next++;
            if (next < text.length() && (text.charAt(next) == '+' || text.charAt(next) == '-')) {
                next++;
            }
            skipDigits();
        }
        if (leadingZero) {
            throw problem("a number begins with a zero");
        }
        return valueOf(text.substring(begin, next));
    }

    private static Number valueOf(String digits) {
        Double value = Double.valueOf(digits);
        if (value.isInfinite()) {
            return new HugeNumber(digits);
        }
        if (Math.abs(value) >= FIRST_ROUNDED && digits.matches("-?\\d+")) {
            try {
                return Long.valueOf(digits);
            } catch (NumberFormatException tooLarge) {
                return new HugeNumber(digits);
            }
        }
        return value;
    }

    private void skipDigits() throws JsonException {
        int begin = next;
        while (next < text.length() && text.charAt(next) >= '0' && text.charAt(next) <= '9') {
            next++;
        }
        if (next == begin) {
            throw problem("a digit is missing");
        }
    }

    /** Skips blanks and then, if it comes next, a character; returns whether it did. */
    private boolean isNext(char c) {
        skipBlanks();
        if (next < text.length() && text.charAt(next) == c) {
            next++;
            return true;
        }
        return false;
    }

    private void skipBlanks() {
        while (next < text.length() && " \t\r\n".indexOf(text.charAt(next)) >= 0) {
            next++;
        }
    }

    private char peek() throws JsonException {
        if (next >= text.length()) {
            throw problem("the text ends too early");
        }
        return text.charAt(next);
    }

    private JsonException problem(String what) {
        return new JsonException(what, next);
    }
}
