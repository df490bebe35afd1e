package faultline.engine.trace;

import java.util.Arrays;

/**
 * A block of rows of a trace as values. Each row stores only the cells that differ from those above, because most are
 * equal. The thread of the run fills it; the thread that writes the trace turns it into text.
 */
final class TraceRows {

    /** Marks a word instead of a number; no number has these bits. */
    static final long WORD = Double.doubleToLongBits(Double.NaN) + 1;

    /** Differs from every cell. */
    private static final long NO_CELL = WORD + 1;

    /** A block is full when it has more changed cells than this. */
    private static final int ROOM = 1 << 14;

    private final int maxRows;
    /** The bits or {@link #WORD}, the word if it has one, and the column of each changed cell, row by row. */
    private final long[] values;

    private final String[] words;
    private final int[] columns;
    /** The end of each row's changed cells. */
    private final int[] ends;

    /** The bits or {@link #WORD}, and the word, of each column in the last row; of this block or of the one before. */
    private final long[] above;

    private final String[] wordsAbove;

    private int rows;
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
        this.maxRows = Math.min(maxRows, ROOM);
        values = new long[ROOM + above.length];
        words = new String[values.length];
        columns = new int[values.length];
        ends = new int[this.maxRows];
    }

    /** Returns a new block for the next rows; this block gets no more rows. */
    TraceRows next() {
        return new TraceRows(above, wordsAbove, maxRows);
    }

    /** Empties a block that has been written, for the rows after the last block of the same trace. */
    void clear() {
        rows = 0;
        size = 0;
    }

    /** Appends a cell with a number. */
    void append(double number) {
        long bits = Double.doubleToLongBits(number);
        if (bits != above[column]) {
            above[column] = bits;
            values[size] = bits;
            columns[size++] = column;
        }
        column++;
    }

    /** Appends a cell with a word. */
    @SuppressWarnings("ReferenceEquality") // Comparing the words would take as long as copying an equal one.
    void append(String word) {
        if (word != wordsAbove[column] || above[column] != WORD) {
            wordsAbove[column] = word;
            above[column] = WORD;
            values[size] = WORD;
            words[size] = word;
            columns[size++] = column;
        }
        column++;
    }

    /** Repeats the next cells of the row above, which must exist. */
    void repeat(int cells) {
        column += cells;
    }

    /** Ends a row after its last cell. */
    void endRow() {
        ends[rows++] = size;
        column = 0;
    }

    /** Returns whether there may be no room for another row. */
    boolean isFull() {
        return rows == maxRows || size > ROOM;
    }

    int rows() {
        return rows;
    }

    /** Returns the end of a row's changed cells, which begin where those of the row before end. */
    int end(int row) {
        return ends[row];
    }

    /** Returns one of the changed cells. */
    long value(int change) {
        return values[change];
    }

    /** Returns the column of one of the changed cells. */
    int column(int change) {
        return columns[change];
    }

    /** Returns the word of one of the changed cells. */
    String word(int change) {
        return words[change];
    }
}
