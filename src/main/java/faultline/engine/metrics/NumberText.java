package faultline.engine.metrics;

/**
 * Turns numbers into text, and keeps the last one: in most rows of a trace many numbers are those of the row before,
 * and the conversion takes most of the time of a row. Confined to one thread.
 */
final class NumberText {

    private long bits = Double.doubleToRawLongBits(0.0);
    private String text = "0.0";

    /** Returns the shortest text that reads back to the same bits, as {@link Double#toString(double)} does. */
    String of(double number) {
        long newBits = Double.doubleToRawLongBits(number);
        if (newBits != bits) {
            bits = newBits;
            text = Double.toString(number);
        }
        return text;
    }
}
