package faultline.engine.metrics;

import faultline.io.ShortestDecimal;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Rows of a trace while they are put together: bytes in UTF-8, written when there are many. */
final class TraceBlock {

    /** From this length on, bytes, rows are written. */
    private static final int SIZE = 1 << 13;

    /** No run has as many ticks as an integer of this length. */
    private static final int MAX_INTEGER_LENGTH = 18;

    private byte[] text = new byte[2 * SIZE];
    private int length;
    private int number;

    /** Makes room for some more bytes. */
    private void reserve(int more) {
        if (length + more > text.length) {
            text = Arrays.copyOf(text, 2 * (length + more));
        }
    }

    /** Returns the number of blocks before this one. */
    int number() {
        return number;
    }

    /** Returns where the next text begins. */
    int length() {
        return length;
    }

    void append(String word) {
        byte[] bytes = word.getBytes(StandardCharsets.UTF_8);
        reserve(bytes.length);
        System.arraycopy(bytes, 0, text, length, bytes.length);
        length += bytes.length;
    }

    /** Appends an ASCII character. */
    void append(char character) {
        reserve(1);
        text[length++] = (byte) character;
    }

    /** Appends an integer, not negative. */
    void append(long integer) {
        reserve(MAX_INTEGER_LENGTH);
        int end = length + 1;
        for (long power = 10; power <= integer; power *= 10) {
            end++;
        }
        long rest = integer;
        for (int i = end - 1; i >= length; i--) {
            text[i] = (byte) ('0' + rest % 10);
            rest /= 10;
        }
        length = end;
    }

    /** Appends the shortest text that reads back to the same bits. */
    void append(double finite) {
        reserve(ShortestDecimal.ROOM);
        length = ShortestDecimal.write(finite, text, length);
    }

    /** Appends what is in this block already. */
    void repeat(int start, int end) {
        int count = end - start;
        reserve(count);
        System.arraycopy(text, start, text, length, count);
        length += count;
    }

    void endCell() {
        append(',');
    }

    /** Ends a row after its last cell has been ended. */
    void endRow() {
        text[length - 1] = '\n';
    }

    /** Writes the rows if they are many, and begins another block. */
    void writeIfLong(OutputStream out) throws IOException {
        if (length >= SIZE) {
            write(out);
        }
    }

    /** Writes the rows and begins another block. */
    void write(OutputStream out) throws IOException {
        out.write(text, 0, length);
        length = 0;
        number++;
    }
}
