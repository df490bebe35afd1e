package faultline.engine.metrics;

/**
 * Appends the numbers of a column: in most rows of a trace many numbers are those of the row before, whose text is
 * copied. Confined to one thread.
 */
final class NumberText {

    private long bits;
    /** The block in which the text of the last number is; -1 for none. */
    private int block = -1;

    private int start;
    private int end;

    /**
     * Appends a cell: the shortest text that reads back to the same bits, or nothing for a number that is not finite.
     */
    void appendCell(double number, TraceBlock row) {
        append(number, row);
        row.endCell();
    }

    private void append(double number, TraceBlock row) {
        long newBits = Double.doubleToRawLongBits(number);
        int newStart = row.length();
        if (newBits == bits && block == row.number()) {
            row.repeat(start, end);
        } else {
            bits = newBits;
            block = row.number();
            if (Double.isFinite(number)) {
                row.append(number);
            }
        }
        start = newStart;
        end = row.length();
    }
}
