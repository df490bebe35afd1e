package faultline.gui.panel;

import faultline.geometry.Degrees;

/** An angle in degrees, remembered, because the exact conversion is slow and asked for with every snapshot. */
final class CachedDegrees {

    private double radians;
    private double degrees;

    double toDegrees(double newRadians) {
        if (newRadians != radians) {
            radians = newRadians;
            degrees = Double.parseDouble(Degrees.toText(radians));
        }
        return degrees;
    }
}
