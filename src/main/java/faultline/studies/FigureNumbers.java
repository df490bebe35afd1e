package faultline.studies;

import java.util.Locale;

/** Numbers as figures write them. */
final class FigureNumbers {

    private FigureNumbers() {}

    /** A number with so many decimals and a true minus sign. */
    static String format(double value, int decimals) {
        String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
        boolean zero = text.chars().allMatch(c -> "-0.".indexOf(c) >= 0);
        return (zero ? text.replace("-", "") : text).replace('-', '\u2212');
    }
}
