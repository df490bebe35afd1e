package faultline.engine.metrics;

/**
 * Rows of a trace as values, one after another in the order of the columns. The thread of the run fills them; the
 * thread that writes the trace turns them into text.
 */
final class TraceRows {

    private final int columns;
    private final double[] numbers;
    /** For each cell a word, or null if the cell is a number. */
    private final String[] words;

    private int size;

    /** Creates an empty block for a number of rows. */
    TraceRows(int columns, int rows) {
        this.columns = columns;
        numbers = new double[columns * rows];
        words = new String[numbers.length];
    }

    /** Appends a cell with a number. */
    void append(double number) {
        numbers[size++] = number;
    }

    /** Appends a cell with a word. */
    void append(String word) {
        words[size++] = word;
    }

    boolean isFull() {
        return size == numbers.length;
    }

    int columns() {
        return columns;
    }

    int rows() {
        return size / columns;
    }

    /** Returns the word of a cell, or null if it is a number. */
    String word(int row, int column) {
        return words[row * columns + column];
    }

    double number(int row, int column) {
        return numbers[row * columns + column];
    }

    /** Returns whether a cell certainly has the text of the cell above it. */
    boolean repeatsAbove(int row, int column) {
        int cell = row * columns + column;
        return row > 0 && areSame(cell, cell - columns);
    }

    /** Returns whether a cell certainly has the text of the cell to its left. */
    boolean repeatsLeft(int row, int column) {
        int cell = row * columns + column;
        return column > 0 && areSame(cell, cell - 1);
    }

    @SuppressWarnings("ReferenceEquality") // A copy of an equal word would cost as much as to compare it.
    private boolean areSame(int one, int other) {
        return Double.doubleToRawLongBits(numbers[one]) == Double.doubleToRawLongBits(numbers[other])
                && words[one] == words[other];
    }
}
