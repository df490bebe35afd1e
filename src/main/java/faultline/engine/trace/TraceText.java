package faultline.engine.trace;

import faultline.io.MessageText;
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

    /** The most bytes that a cell with a number may use, also of an integer, with the comma after it. */
    private static final int NUMBER_ROOM = ShortestDecimal.ROOM + 1;

    /** The text is written when it is longer than this. */
    private static final int FLUSH_LENGTH = 1 << 16;

    private byte[] text = new byte[MIN_SIZE];
    private int length;
    /** The bytes that a row may need beside its new words. */
    private int rowRoom;
    /** The end of the written text. */
    private int written;

    /**
     * The starts of the cells: of this row before the next cell, of the row above from there on; last, the end of the
     * row.
     */
    private final int[] starts;

    /** The next changed cell of the block. */
    private int place;

    TraceText(int columns) {
        starts = new int[columns + 1];
    }

    /** Appends a row of words. */
    void append(Iterable<String> row) {
        for (String cell : row) {
            appendCell(cell);
        }
        endRow();
    }

    /**
     * Appends all rows of a block and writes them, some at a time, so that the text stays in the processor's cache.
     * Their first cells are numbers of ticks, written as integers.
     */
    void write(TraceRows rows, OutputStream out) throws IOException {
        place = 0;
        for (int row = 0; row < rows.rows(); row++) {
            append(rows, rows.end(row));
            if (length > FLUSH_LENGTH || row + 1 == rows.rows()) {
                write(out);
            }
        }
    }

    /** Appends the next row of a block, up to the end of its changed cells. */
    private void append(TraceRows rows, int end) {
        reserveRow();
        int unwritten = 0;
        for (; place < end; place++) {
            int column = rows.column(place);
            repeatAbove(unwritten, column);
            appendCell(rows, column, column == unwritten);
            unwritten = column + 1;
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
        long value = rows.value(place);
        int start = length;
        if (value == TraceRows.WORD) {
            appendCell(MessageText.csvCell(rows.word(place)));
        } else if (column == 0) {
            append((long) Double.longBitsToDouble(value));
        } else if (leftChanged && column > 1 && value == rows.value(place - 1)) {
            repeat(starts[column - 1], length);
        } else {
            double number = Double.longBitsToDouble(value);
            length = Double.isFinite(number) ? ShortestDecimal.write(number, text, length) : length;
            text[length++] = ',';
        }
        starts[column] = start;
    }

    private void appendCell(String word) {
        byte[] bytes = word.getBytes(StandardCharsets.UTF_8);
        reserve(bytes.length + 1 + rowRoom);
        System.arraycopy(bytes, 0, text, length, bytes.length);
        length += bytes.length;
        text[length++] = ',';
    }

    /** Appends a cell with an integer that is not negative. */
    private void append(long integer) {
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
        System.arraycopy(text, start, text, length, count);
        length += count;
    }

    /** Ends a row after its last cell. */
    private void endRow() {
        text[length - 1] = '\n';
    }

    /** Makes room for a row with any numbers and the words of the row above; new words make room for themselves. */
    private void reserveRow() {
        rowRoom = length - starts[0] + (starts.length - 1) * NUMBER_ROOM;
        reserve(rowRoom);
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
