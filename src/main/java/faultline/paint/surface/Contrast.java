package faultline.paint.surface;

import java.awt.Color;

/** The contrast of two colours as the Web Content Accessibility Guidelines 2.2 define it. */
public final class Contrast {

    private Contrast() {}

    /**
     * {@return the ratio of contrast, from 1 to 21}
     *
     * @param one a colour, whose alpha is ignored
     * @param other another colour, whose alpha is ignored
     */
    public static double of(Color one, Color other) {
        double a = luminance(one) + 0.05;
        double b = luminance(other) + 0.05;
        return Math.max(a, b) / Math.min(a, b);
    }

    private static double luminance(Color colour) {
        return 0.2126 * linear(colour.getRed())
                + 0.7152 * linear(colour.getGreen())
                + 0.0722 * linear(colour.getBlue());
    }

    private static double linear(int channel) {
        double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
