package faultline.engine.metrics;

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

    private byte[] text = new byte[MIN_SIZE];
    private int length;

    /** Where the cells of the row begin, from the next one on those of the row above; the last is the row's end. */
    private final int[] starts;

    TraceText(int columns) {
        starts = new int[columns + 1];
    }

    /** Appends a row of words. */
    void append(Iterable<String> row) {
        row.forEach(this::appendCell);
        endRow();
    }

    /** Appends all rows of a block. Their first cells are numbers of ticks, written as integers. */
    void append(TraceRows rows) {
        for (int row = 0; row < rows.rows(); row++) {
            append(rows, row);
        }
    }

    private void append(TraceRows rows, int row) {
        starts[0] = length;
        append((long) rows.number(row, 0));
        int unwritten = 1;
        for (int column = 1; column < rows.columns(); column++) {
            if (!rows.repeatsAbove(row, column)) {
                repeatAbove(unwritten, column);
                starts[column] = length;
                appendCell(rows, row, column);
                unwritten = column + 1;
            }
        }
        repeatAbove(unwritten, rows.columns());
        starts[rows.columns()] = length;
        endRow();
    }

    /** Appends some cells of the row above. */
    private void repeatAbove(int from, int to) {
        int moved = length - starts[from];
        repeat(starts[from], starts[to]);
        for (int column = from; column < to; column++) {
            starts[column] += moved;
        }
    }

    private void appendCell(TraceRows rows, int row, int column) {
        String word = rows.word(row, column);
        double number = rows.number(row, column);
        if (column > 1 && rows.repeatsLeft(row, column)) {
            repeat(starts[column - 1], length);
        } else if (word != null) {
            appendCell(word);
        } else {
            reserve(ShortestDecimal.ROOM + 1);
            length = Double.isFinite(number) ? ShortestDecimal.write(number, text, length) : length;
            text[length++] = ',';
        }
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

    /** Writes the text and begins another one. */
    void write(OutputStream out) throws IOException {
        out.write(text, 0, length);
        length = 0;
    }
}
