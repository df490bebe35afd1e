package faultline.gui.panel;

import faultline.geometry.Degrees;

/** An angle in degrees, remembered, because the exact conversion is slow and asked for with every snapshot. */
final class ShownDegrees {

    private double radians;
    private double degrees;

    double of(double newRadians) {
        if (newRadians != radians) {
            radians = newRadians;
            degrees = Double.parseDouble(Degrees.toText(radians));
        }
        return degrees;
    }
}
