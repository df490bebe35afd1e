package faultline.gui.text;

import faultline.geometry.Angles;
import java.util.Locale;

/** Formats angles in degrees. */
public final class AngleText {

    private AngleText() {}

    /**
     * Returns an angle in (-180, 180] degrees, without its unit. The value is rounded before it is normalised, so that
     * an angle just above -180 degrees reads 180, and there is no negative zero.
     *
     * @param radians the angle, radians
     * @param decimals the number of decimals
     */
    public static String degrees(double radians, int decimals) {
        return String.format(Locale.ROOT, "%." + decimals + "f", rounded(radians, decimals));
    }

    /** Returns an angle as {@link #degrees} does, with a sign even if it is not negative. */
    public static String signedDegrees(double radians, int decimals) {
        return String.format(Locale.ROOT, "%+." + decimals + "f", rounded(radians, decimals));
    }

    private static double rounded(double radians, int decimals) {
        double scale = Math.pow(10, decimals);
        double degrees = Math.toDegrees(Angles.normalize(radians));
        double rounded = Math.round(scale * degrees) / scale;
        return rounded <= -180 ? rounded + 360 : rounded;
    }
}
