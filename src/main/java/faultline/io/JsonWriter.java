package faultline.io;

/**
 * Writes one JSON object as one line. Numbers must be finite; each has the shortest text that reads back to the same
 * bits, on any JDK.
 */
public final class JsonWriter {

    private final StringBuilder text = new StringBuilder(256);
    private boolean needsComma;

    /** Begins an object. */
    public JsonWriter() {
        text.append('{');
    }

    /**
     * {@return this writer, which has begun a member whose value follows}
     *
     * @param name the member's name
     */
    public JsonWriter name(String name) {
        comma();
        appendQuoted(text, name);
        text.append(':');
        needsComma = false;
        return this;
    }

    /**
     * {@return this writer, which has written a string member}
     *
     * @param name the member's name
     * @param value the member's value
     */
    public JsonWriter member(String name, String value) {
        name(name);
        return value(value);
    }

    /**
     * {@return this writer, which has written a number member}
     *
     * @param name the member's name
     * @param value the member's value, finite
     */
    public JsonWriter member(String name, double value) {
        name(name);
        return value(value);
    }

    /**
     * {@return this writer, which has written a whole-number member}
     *
     * @param name the member's name
     * @param value the member's value
     */
    public JsonWriter member(String name, long value) {
        name(name);
        comma();
        text.append(value);
        return this;
    }

    /**
     * {@return this writer, which has written a truth value member}
     *
     * @param name the member's name
     * @param value the member's value
     */
    public JsonWriter member(String name, boolean value) {
        name(name);
        return value(value);
    }

    /**
     * {@return this writer, which has written a string}
     *
     * @param value the string
     */
    public JsonWriter value(String value) {
        comma();
        appendQuoted(text, value);
        return this;
    }

    /**
     * {@return this writer, which has written a finite number, a whole one without a fraction}
     *
     * @param value the number, finite
     */
    public JsonWriter value(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("JSON has no number for " + value);
        }
        comma();
        if (value == Math.rint(value) && Math.abs(value) < 1e15 && (value != 0 || 1 / value > 0)) {
            text.append((long) value);
        } else {
            text.append(ShortestDecimal.text(value));
        }
        return this;
    }

    /**
     * {@return this writer, which has written a truth value}
     *
     * @param value the truth value
     */
    public JsonWriter value(boolean value) {
        comma();
        text.append(value);
        return this;
    }

    /** {@return this writer, which has written {@code null}} */
    public JsonWriter nullValue() {
        comma();
        text.append("null");
        return this;
    }

    /** {@return this writer, which has begun an array} */
    public JsonWriter beginArray() {
        return open('[');
    }

    /** {@return this writer, which has ended an array} */
    public JsonWriter endArray() {
        return close(']');
    }

    /** {@return this writer, which has begun an object} */
    public JsonWriter beginObject() {
        return open('{');
    }

    /** {@return this writer, which has ended an object} */
    public JsonWriter endObject() {
        return close('}');
    }

    private JsonWriter open(char bracket) {
        comma();
        text.append(bracket);
        needsComma = false;
        return this;
    }

    private JsonWriter close(char bracket) {
        text.append(bracket);
        needsComma = true;
        return this;
    }

    private void comma() {
        if (needsComma) {
            text.append(',');
        }
        needsComma = true;
    }

    /**
     * {@return a text as a JSON string, with its quotation marks}
     *
     * @param value the text
     */
    public static String quoted(String value) {
        StringBuilder text = new StringBuilder();
        appendQuoted(text, value);
        return text.toString();
    }

    private static void appendQuoted(StringBuilder text, String value) {
        text.append('"');
        for (int i = 0; i < value.length(); i++) {
            char c = value.charAt(i);
            if (c == '"' || c == '\\') {
                text.append('\\').append(c);
            } else if (MessageText.isControl(c)) {
                text.append("\\u");
                for (int shift = 12; shift >= 0; shift -= 4) {
                    text.append(Character.forDigit(c >> shift & 0xf, 16));
                }
            } else {
                text.append(c);
            }
        }
        text.append('"');
    }

    /** {@return the ended object as text, without a line break} */
    public String finish() {
        return text.append('}').toString();
    }
}
