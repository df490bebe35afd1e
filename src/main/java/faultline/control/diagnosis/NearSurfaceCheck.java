package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * Predicts that a surface very near to a sensor that looks diagonally ahead crosses the path: if the front sensor saw
 * it, the robot would have turned before.
 */
final class NearSurfaceCheck {

    /** A surface this near crosses the path, metres. */
    private static final double NEAR = 0.14;

    /** The same as a share of the wanted distance from the wall, where that is less. */
    private static final double NEAR_SHARE = 0.56;

    /** The number of measurements that must agree, so that a single wrong reading is not taken as a surface. */
    private static final int MEASUREMENTS = 3;

    /** Measurements that differ by less than this from one inspection to the next agree, metres. */
    private static final double STEP = 0.05;

    private NearSurfaceCheck() {}

    static boolean applies(MountedCone cone) {
        double bearing = Math.abs(cone.bearing());
        return bearing > cone.half() + 0.2 && bearing < 1.2;
    }

    /**
     * Returns the distance ahead of the sensor at which the surface crosses the path if it faces the sensor, metres;
     * infinite if none is near.
     */
    static double expectedAhead(MountedCone cone, MeasurementRing measurements, double wantedDistance) {
        double reading = measurements.reading(0);
        if (reading > Math.min(NEAR, NEAR_SHARE * wantedDistance) || !measurements.has(MEASUREMENTS - 1)) {
            return Reading.NOTHING;
        }
        for (int i = 1; i < MEASUREMENTS; i++) {
            if (measurements.reading(i) < 0 || Math.abs(measurements.reading(i) - measurements.reading(i - 1)) > STEP) {
                return Reading.NOTHING;
            }
        }
        double bearing = Math.abs(cone.bearing());
        return (reading + Math.abs(cone.y()) * StrictMath.sin(bearing)) / StrictMath.cos(bearing);
    }
}
