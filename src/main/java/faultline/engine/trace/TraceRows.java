package faultline.engine.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A block of rows of a trace as values. Each row stores only the cells that differ from those above, because most are
 * equal. The thread of the run fills it; the thread that writes the trace turns it into text.
 */
final class TraceRows {

    /** Marks a word instead of a number; no number has these bits. */
    static final long WORD = Double.doubleToLongBits(Double.NaN) + 1;

    /** Differs from every cell. */
    private static final long NO_CELL = WORD + 1;

    /** The capacity in values, unless one row has more. */
    private static final int ROOM = 1 << 14;

    private final int maxRows;
    /** For each row the bits of the columns that changed, {@link #marks} of them, and after them the changed values. */
    private final long[] values;
    /** The words among the changed values, in their order. */
    private final List<String> words = new ArrayList<>();

    /** The bits or {@link #WORD}, and the word, of each column in the last row; of this block or of the one before. */
    private final long[] above;

    private final String[] wordsAbove;

    private final int marks;
    private int rows;
    /** The index of the next marks of the row. */
    private int place;
    /** The changes of the columns that the next marks describe. */
    private long changed;

    private int column;
    private int size;

    /** Creates the first block of a trace, which is full after a number of rows or of changes. */
    TraceRows(int columns, int maxRows) {
        this(new long[columns], new String[columns], maxRows);
        Arrays.fill(above, NO_CELL);
    }

    private TraceRows(long[] above, String[] wordsAbove, int maxRows) {
        this.above = above;
        this.wordsAbove = wordsAbove;
        this.maxRows = maxRows;
        marks = (above.length - 1) / Long.SIZE + 1;
        values = new long[Math.max(ROOM, marks + above.length)];
        size = marks;
    }

    /** Returns a new block for the next rows; this block gets no more rows. */
    TraceRows next() {
        return new TraceRows(above, wordsAbove, maxRows);
    }

    /** Empties a block that has been written, for the rows after the last block of the same trace. */
    void clear() {
        words.clear();
        rows = 0;
        place = 0;
        size = marks;
    }

    /** Appends a cell with a number. */
    void append(double number) {
        long bits = Double.doubleToLongBits(number);
        if (bits != above[column]) {
            change(bits);
        }
        endCell();
    }

    /** Appends a cell with a word. */
    @SuppressWarnings("ReferenceEquality") // Comparing the words would take as long as copying an equal one.
    void append(String word) {
        if (word != wordsAbove[column] || above[column] != WORD) {
            wordsAbove[column] = word;
            words.add(word);
            change(WORD);
        }
        endCell();
    }

    /** Repeats the next cells of the row above, which must exist. */
    void repeat(int cells) {
        int next = column + cells;
        for (int mark = column / Long.SIZE; mark < next / Long.SIZE; mark++) {
            endMarks();
        }
        column = next;
    }

    private void change(long value) {
        above[column] = value;
        values[size++] = value;
        changed |= 1L << column;
    }

    private void endCell() {
        column++;
        if (column % Long.SIZE == 0) {
            endMarks();
        }
    }

    private void endMarks() {
        values[place++] = changed;
        changed = 0;
    }

    /** Ends a row after its last cell. */
    void endRow() {
        if (column % Long.SIZE != 0) {
            endMarks();
        }
        rows++;
        place = size;
        size += marks;
        column = 0;
    }

    /** Returns whether there may be no room for another row. */
    boolean isFull() {
        return rows == maxRows || size + above.length > values.length;
    }

    int rows() {
        return rows;
    }

    /** Returns how many values of marks a row begins with: one bit for each column. */
    int marks() {
        return marks;
    }

    /**
     * Returns one of the values: the marks of the first row, its changed cells, the marks of the next row, and so on.
     */
    long value(int place) {
        return values[place];
    }

    /** Returns one of the words among the changed cells. */
    String word(int place) {
        return words.get(place);
    }
}
