package faultline.gui.text;

import faultline.geometry.Degrees;

/**
 * Converts an angle to degrees and caches the result, because the exact conversion is slow and needed for every
 * snapshot.
 */
public final class CachedDegrees {

    private double radians;
    private double degrees;

    /** Returns an angle in degrees. */
    public double toDegrees(double newRadians) {
        if (newRadians != radians) {
            radians = newRadians;
            degrees = Double.parseDouble(Degrees.toText(radians));
        }
        return degrees;
    }
}
