package faultline.gui.batch;

import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A cell of a table of results, whose number is NaN for a text. Numbers are sorted by their values and before texts.
 */
record ResultCell(String text, double number) implements Comparable<ResultCell> {

    /** Shown for a value that does not exist. */
    static final String NONE = "–";

    private static final double MILLIMETRES = 1000;

    static ResultCell ofText(String text) {
        return new ResultCell(text, Double.NaN);
    }

    /** Returns the cell of a number with some decimals; NaN for none. */
    static ResultCell ofNumber(double number, int decimals) {
        return Double.isNaN(number)
                ? ofText(NONE)
                : new ResultCell(String.format(Locale.ROOT, "%." + decimals + "f", number), number);
    }

    /** Returns the cell of a length in millimetres, given in metres. */
    static ResultCell ofMillimetres(double metres) {
        return ofNumber(metres * MILLIMETRES, 1);
    }

    /** Returns the cell of a value, empty for none, in a column of {@code runs.csv}. */
    static ResultCell of(String column, String value) {
        Optional<BigDecimal> number = column.equals("trajectory_hash") ? Optional.empty() : DecimalText.parse(value);
        if (column.equals("distance_rms_m")) {
            return ofMillimetres(number.map(BigDecimal::doubleValue).orElse(Double.NaN));
        }
        return number.map(known -> new ResultCell(value, known.doubleValue()))
                .orElseGet(() -> ofText(word(column, value)));
    }

    /** Returns the word of the user's language for a value of a column, or the value itself. */
    static String word(String column, String value) {
        String prefix = column.endsWith("_kind") ? "fault." : "batch.value.";
        return Stream.of("batch.value." + column + "." + value, prefix + value, "batch.value." + value)
                .filter(Messages::contains)
                .findFirst()
                .map(Messages::get)
                .orElse(value);
    }

    /** Returns whether this is a number. */
    boolean isNumber() {
        return !Double.isNaN(number);
    }

    @Override
    public int compareTo(ResultCell other) {
        if (!isNumber() && !other.isNumber()) {
            return text.compareTo(other.text);
        }
        return Double.compare(number, other.number);
    }

    @Override
    public String toString() {
        return text;
    }
}
