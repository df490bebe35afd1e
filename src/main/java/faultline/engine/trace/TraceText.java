package faultline.engine.trace;

import faultline.io.ShortestDecimal;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The text of rows of a trace, in UTF-8. In most rows most cells are those of the row above, whose text is copied, many
 * cells at a time. Belongs to one thread.
 */
final class TraceText {

    private static final int MIN_SIZE = 1 << 12;

    /** No run has as many ticks as an integer of this length. */
    private static final int MAX_INTEGER_LENGTH = 18;

    /** The text is written when it is longer than this. */
    private static final int FLUSH_LENGTH = 1 << 16;

    private byte[] text = new byte[MIN_SIZE];
    private int length;
    /** The end of the written text. */
    private int written;

    /**
     * The starts of the cells: of this row before the next cell, of the row above from there on; last, the end of the
     * row.
     */
    private final int[] starts;

    /** The next value and the next word of the block. */
    private int place;

    private int word;

    TraceText(int columns) {
        starts = new int[columns + 1];
    }

    /** Appends a row of words. */
    void append(Iterable<String> row) {
        row.forEach(this::appendCell);
        endRow();
    }

    /**
     * Appends all rows of a block and writes them, some at a time, so that the text stays in the processor's cache.
     * Their first cells are numbers of ticks, written as integers.
     */
    void write(TraceRows rows, OutputStream out) throws IOException {
        place = 0;
        word = 0;
        for (int row = 0; row < rows.rows(); row++) {
            append(rows);
            if (length > FLUSH_LENGTH || row + 1 == rows.rows()) {
                write(out);
            }
        }
    }

    /** Appends the next row of a block. */
    private void append(TraceRows rows) {
        int marks = place;
        place += rows.marks();
        int unwritten = 0;
        for (int i = 0; i < rows.marks(); i++) {
            for (long changed = rows.value(marks + i); changed != 0; changed &= changed - 1) {
                int column = i * Long.SIZE + Long.numberOfTrailingZeros(changed);
                repeatAbove(unwritten, column);
                appendCell(rows, column, column == unwritten);
                unwritten = column + 1;
            }
        }
        repeatAbove(unwritten, starts.length - 1);
        starts[starts.length - 1] = length;
        endRow();
    }

    /** Appends some cells of the row above. */
    private void repeatAbove(int from, int to) {
        if (from == to) {
            return;
        }
        int moved = length - starts[from];
        repeat(starts[from], starts[to]);
        for (int column = from; column < to; column++) {
            starts[column] += moved;
        }
    }

    /** Appends the next changed cell of a block. */
    private void appendCell(TraceRows rows, int column, boolean leftChanged) {
        long value = rows.value(place++);
        int start = length;
        if (value == TraceRows.WORD) {
            appendCell(rows.word(word++));
        } else if (column == 0) {
            append((long) Double.longBitsToDouble(value));
        } else if (leftChanged && column > 1 && value == rows.value(place - 2)) {
            repeat(starts[column - 1], length);
        } else {
            double number = Double.longBitsToDouble(value);
            reserve(ShortestDecimal.ROOM + 1);
            length = Double.isFinite(number) ? ShortestDecimal.write(number, text, length) : length;
            text[length++] = ',';
        }
        starts[column] = start;
    }

    private void appendCell(String word) {
        byte[] bytes = word.getBytes(StandardCharsets.UTF_8);
        reserve(bytes.length + 1);
        System.arraycopy(bytes, 0, text, length, bytes.length);
        length += bytes.length;
        text[length++] = ',';
    }

    /** Appends a cell with an integer that is not negative. */
    private void append(long integer) {
        reserve(MAX_INTEGER_LENGTH + 1);
        int end = length + 1;
        for (long power = 10; power <= integer; power *= 10) {
            end++;
        }
        long rest = integer;
        for (int i = end - 1; i >= length; i--) {
            text[i] = (byte) ('0' + rest % 10);
            rest /= 10;
        }
        text[end] = ',';
        length = end + 1;
    }

    /** Appends a part of this text. */
    private void repeat(int start, int end) {
        int count = end - start;
        reserve(count);
        System.arraycopy(text, start, text, length, count);
        length += count;
    }

    /** Ends a row after its last cell. */
    private void endRow() {
        text[length - 1] = '\n';
    }

    private void reserve(int more) {
        if (length + more > text.length) {
            text = Arrays.copyOf(text, 2 * (length + more));
        }
    }

    /** Writes the rows that have not been written. The last one remains in the text, for the next one to repeat. */
    private void write(OutputStream out) throws IOException {
        out.write(text, written, length - written);
        int moved = starts[0];
        System.arraycopy(text, moved, text, 0, length - moved);
        for (int column = 0; column < starts.length; column++) {
            starts[column] -= moved;
        }
        length -= moved;
        written = length;
    }
}
