package faultline.gui.text;

import faultline.io.DecimalText;
import java.util.Locale;

/** Formats numbers for users. They have a decimal point in every language, and zero has no sign. */
public final class NumberText {

    private NumberText() {}

    /** Returns a text with a pattern of {@link String#format}. */
    public static String format(String pattern, Object... values) {
        return DecimalText.withoutSignOfZero(String.format(Locale.ROOT, pattern, values));
    }

    /** Returns a number with a pattern of {@link String#format}, or a dash for NaN. */
    public static String formatOrDash(String pattern, double value) {
        return Double.isNaN(value) ? "–" : format(pattern, value);
    }
}
