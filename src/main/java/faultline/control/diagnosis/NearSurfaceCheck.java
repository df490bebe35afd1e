package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * Predicts that a surface very near to a sensor that looks diagonally ahead crosses the path: if the front sensor saw
 * it, the robot would have turned before.
 *
 * <p>On the wall's side, the surface may also be a small piece of the wall that ends before the front sensor's cone. On
 * a straight path the reading of a piece beside the path falls more slowly than that of a surface that the robot
 * approaches. A robot that turns towards the wall turns its front sensor to places that it has not seen yet.
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

    /** A robot that turns faster than this does not drive straight on, radians per second. */
    private static final double TURNING = 0.3;

    /** The share of these distances that is near on the wall's side while the robot turns towards the wall. */
    private static final double TURNING_SHARE = 0.6;

    /** On the wall's side the reading falls by at least this share of the distance that the sensor has moved. */
    private static final double FALL = 0.65;

    private NearSurfaceCheck() {}

    /**
     * Returns the distance ahead of the sensor at which the surface crosses the path if it faces the sensor, metres;
     * infinite if none is near.
     *
     * @param cone of the sensor
     * @param measurements of the sensor
     * @param wantedDistance the distance that the robot keeps from the wall, metres
     * @param turnRate of the robot, radians per second, positive towards the wall
     */
    static double expectedAhead(
            MountedCone cone, MeasurementRing measurements, double wantedDistance, double turnRate) {
        double reading = measurements.reading(0);
        double limit = Math.min(NEAR, NEAR_SHARE * wantedDistance) * (looksAtWall(cone) ? share(turnRate) : 1);
        if (reading > limit || !measurements.has(MEASUREMENTS - 1)) {
            return Reading.NOTHING;
        }
        for (int i = 1; i < MEASUREMENTS; i++) {
            if (Math.abs(measurements.reading(i) - measurements.reading(i - 1)) > STEP) {
                return Reading.NOTHING;
            }
        }
        if (looksAtWall(cone) && !isApproached(measurements)) {
            return Reading.NOTHING;
        }
        double bearing = Math.abs(cone.bearing());
        return (reading + Math.abs(cone.y()) * StrictMath.sin(bearing)) / StrictMath.cos(bearing);
    }

    private static boolean looksAtWall(MountedCone cone) {
        return cone.bearing() > 0;
    }

    /** Returns the share of the limit that applies on the wall's side; none if the robot turns away from the wall. */
    private static double share(double turnRate) {
        if (turnRate < -TURNING) {
            return 0;
        }
        return turnRate > TURNING ? TURNING_SHARE : 1;
    }

    /** Returns whether the reading falls as fast as that of a surface that faces the sensor. */
    private static boolean isApproached(MeasurementRing measurements) {
        int oldest = MEASUREMENTS - 1;
        double moved = StrictMath.hypot(
                measurements.x(0) - measurements.x(oldest), measurements.y(0) - measurements.y(oldest));
        return measurements.reading(oldest) - measurements.reading(0) >= FALL * moved;
    }
}
