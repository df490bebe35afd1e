package faultline.engine.metrics;

import java.io.IOException;
import java.io.Writer;
import java.util.Arrays;

/** A row of a trace while it is put together: plain characters, used again for the next row. */
public final class TraceRow {

    private char[] text = new char[1024];
    private int length;

    private void reserve(int more) {
        if (length + more > text.length) {
            text = Arrays.copyOf(text, 2 * (length + more));
        }
    }

    void append(char character) {
        reserve(1);
        text[length++] = character;
    }

    void append(String word) {
        reserve(word.length());
        word.getChars(0, word.length(), text, length);
        length += word.length();
    }

    /** Appends the first characters of an array. */
    void append(char[] characters, int count) {
        reserve(count);
        System.arraycopy(characters, 0, text, length, count);
        length += count;
    }

    /** Writes the row, and empties it. */
    void writeTo(Writer out) throws IOException {
        out.write(text, 0, length);
        length = 0;
    }
}
