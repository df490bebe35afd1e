package faultline.io;

/** Writes one JSON object as one line. Numbers must be finite and read back to the same bits. */
public final class JsonWriter {

    private final StringBuilder text = new StringBuilder(256);
    private boolean needsComma;

    /** Begins an object. */
    public JsonWriter() {
        text.append('{');
    }

    /**
     * Begins a member, whose value follows.
     *
     * @param name the member's name
     * @return this writer
     */
    public JsonWriter name(String name) {
        comma();
        appendQuoted(name);
        text.append(':');
        needsComma = false;
        return this;
    }

    /**
     * Writes a string member.
     *
     * @param name the member's name
     * @param value the member's value
     * @return this writer
     */
    public JsonWriter member(String name, String value) {
        name(name);
        return value(value);
    }

    /**
     * Writes a number member.
     *
     * @param name the member's name
     * @param value the member's value, finite
     * @return this writer
     */
    public JsonWriter member(String name, double value) {
        name(name);
        return value(value);
    }

    /**
     * Writes a whole-number member.
     *
     * @param name the member's name
     * @param value the member's value
     * @return this writer
     */
    public JsonWriter member(String name, long value) {
        name(name);
        comma();
        text.append(value);
        return this;
    }

    /**
     * Writes a truth value member.
     *
     * @param name the member's name
     * @param value the member's value
     * @return this writer
     */
    public JsonWriter member(String name, boolean value) {
        name(name);
        return value(value);
    }

    /**
     * Writes a string.
     *
     * @param value the string
     * @return this writer
     */
    public JsonWriter value(String value) {
        comma();
        appendQuoted(value);
        return this;
    }

    /**
     * Writes a finite number, a whole one without a fraction.
     *
     * @param value the number, finite
     * @return this writer
     */
    public JsonWriter value(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("JSON has no number for " + value);
        }
        comma();
        if (value == Math.rint(value) && Math.abs(value) < 1e15 && (value != 0 || 1 / value > 0)) {
            text.append((long) value);
        } else {
            text.append(value);
        }
        return this;
    }

    /**
     * Writes a truth value.
     *
     * @param value the truth value
     * @return this writer
     */
    public JsonWriter value(boolean value) {
        comma();
        text.append(value);
        return this;
    }

    /**
     * Writes {@code null}.
     *
     * @return this writer
     */
    public JsonWriter nullValue() {
        comma();
        text.append("null");
        return this;
    }

    /**
     * Begins an array.
     *
     * @return this writer
     */
    public JsonWriter beginArray() {
        return open('[');
    }

    /**
     * Ends an array.
     *
     * @return this writer
     */
    public JsonWriter endArray() {
        return close(']');
    }

    /**
     * Begins an object.
     *
     * @return this writer
     */
    public JsonWriter beginObject() {
        return open('{');
    }

    /**
     * Ends an object.
     *
     * @return this writer
     */
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

    private void appendQuoted(String value) {
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

    /**
     * Ends the object.
     *
     * @return the object as text, without a line break
     */
    public String finish() {
        return text.append('}').toString();
    }
}
