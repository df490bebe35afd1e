package faultline.engine.metrics;

import faultline.io.ShortestDecimal;

/**
 * Turns numbers into text, and keeps the last one: in most rows of a trace many numbers are those of the row before,
 * and the conversion takes most of the time of a row. Confined to one thread.
 */
final class NumberText {

    private final char[] text = new char[ShortestDecimal.MAX_LENGTH];
    private long bits;
    private int length = ShortestDecimal.write(0, text);

    /** Appends the shortest text that reads back to the same bits. */
    void append(double number, TraceRow row) {
        long newBits = Double.doubleToRawLongBits(number);
        if (newBits != bits) {
            bits = newBits;
            length = ShortestDecimal.write(number, text);
        }
        row.append(text, length);
    }
}
