package faultline.studies.figure;

import java.util.Locale;

/** Formats numbers for figures. */
public final class FigureNumbers {

    private FigureNumbers() {}

    /** Returns a number with some decimals and a true minus sign. */
    public static String format(double value, int decimals) {
        String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
        boolean zero = text.chars().allMatch(c -> "-0.".indexOf(c) >= 0);
        return (zero ? text.replace("-", "") : text).replace('-', '\u2212');
    }
}
