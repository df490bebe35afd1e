package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * Takes a surface that is very near to a sensor that looks diagonally ahead for one that crosses the path: if the front
 * sensor saw it, the robot would have turned before.
 */
final class NearSurfaceCheck {

    /** A surface this near crosses the path, metres. */
    private static final double NEAR = 0.14;

    /** The same as a share of the wanted distance from the wall, where that is less. */
    private static final double NEAR_SHARE = 0.56;

    /** The claims that must agree, so that a single wrong reading is no surface. */
    private static final int CLAIMS = 3;

    /** Claims that differ by less than this from one inspection to the next agree, metres. */
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
    static double expectedAhead(MountedCone cone, ClaimRing claims, double wantedDistance) {
        double reading = claims.reading(0);
        if (reading > Math.min(NEAR, NEAR_SHARE * wantedDistance) || !claims.has(CLAIMS - 1)) {
            return Reading.NOTHING;
        }
        for (int i = 1; i < CLAIMS; i++) {
            if (claims.reading(i) < 0 || Math.abs(claims.reading(i) - claims.reading(i - 1)) > STEP) {
                return Reading.NOTHING;
            }
        }
        double bearing = Math.abs(cone.bearing());
        return (reading + Math.abs(cone.y()) * StrictMath.sin(bearing)) / StrictMath.cos(bearing);
    }
}
