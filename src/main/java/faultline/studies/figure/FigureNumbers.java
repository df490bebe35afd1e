package faultline.studies.figure;

import faultline.io.DecimalText;

/** Formats numbers for figures. */
public final class FigureNumbers {

    private FigureNumbers() {}

    /** Returns a number with some decimals and a true minus sign. */
    public static String format(double value, int decimals) {
        return DecimalText.formatFixed(value, decimals).replace('-', '\u2212');
    }
}
