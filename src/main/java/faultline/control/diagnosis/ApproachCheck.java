package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * Predicts a surface ahead from a sensor that looks diagonally forward. During straight motion the reading of an object
 * beside the path falls by less than the cosine of the bearing of the cone's inner edge; if it falls faster, the
 * surface extends across that edge, and the rate gives its slant: R = h / cos(e - phi), so -dR/ds = cos(phi) / cos(e -
 * phi), where e is the edge's bearing and phi that of the surface's normal.
 */
final class ApproachCheck {

    /** The rate of the reading is measured over at least this number of measurements. */
    private static final int MIN_POINTS = 4;

    private static final int MAX_POINTS = 7;

    /** The distance over which the rate is measured if fewer than {@link #MAX_POINTS} measurements span it, metres. */
    private static final double SPAN = 0.13;

    /** The minimum distance over which the rate is measured, metres. */
    private static final double MIN_DISTANCE = 0.08;

    /** The margin by which the rate must exceed that of an object beside the path. */
    private static final double MARGIN = 0.14;

    private static final double STRAIGHT = StrictMath.toRadians(3);

    /** A surface that is farther from the path than this may end before it, metres. */
    private static final double BESIDE = 0.29;

    private ApproachCheck() {}

    static boolean applies(MountedCone cone) {
        // The check applies only on the side away from the wall; on the other side the wall itself enters and leaves
        // the cone.
        return cone.bearing() < 0 && cone.looksDiagonally();
    }

    /**
     * Returns the distance ahead of the sensor at which the surface crosses the path, metres; infinite if none is
     * predicted.
     */
    static double expectedAhead(InspectedSensor sensor) {
        MountedCone cone = sensor.cone();
        ConeTable table = sensor.table();
        MeasurementRing measurements = sensor.measurements();
        // The distance of the point on the cone's inner edge from the path.
        double across = Math.abs(cone.y()) + measurements.reading(0) * table.innerSin();
        if (across > BESIDE) {
            return Reading.NOTHING;
        }
        double cos = StrictMath.cos(measurements.axis(0) - cone.bearing());
        double sin = StrictMath.sin(measurements.axis(0) - cone.bearing());
        int points = straightPoints(measurements, cos, sin);
        if (points == 0) {
            return Reading.NOTHING;
        }
        double driven = along(measurements, 0, cos, sin) - along(measurements, points - 1, cos, sin);
        double rate = driven < MIN_DISTANCE ? 0 : -slope(measurements, points, cos, sin);
        if (rate < table.innerCos() + MARGIN) {
            return Reading.NOTHING;
        }
        // tan(phi) = (1 / rate - cos e) / sin e; the surface extends from its point on the edge to the middle of the
        // path.
        double tan = (1 / rate - table.innerCos()) / table.innerSin();
        return measurements.reading(0) * table.innerCos() + across * tan;
    }

    /**
     * Returns the number of measurements to use: the last ones that span {@link #SPAN}. It is 0 if not all of them saw
     * something while the robot drove straight.
     */
    private static int straightPoints(MeasurementRing measurements, double cos, double sin) {
        for (int i = 0; i < MAX_POINTS; i++) {
            if (!measurements.has(i)
                    || measurements.reading(i) < 0
                    || Math.abs(measurements.axis(i) - measurements.axis(0)) > STRAIGHT) {
                return 0;
            }
            if (i >= MIN_POINTS - 1 && along(measurements, 0, cos, sin) - along(measurements, i, cos, sin) >= SPAN) {
                return i + 1;
            }
        }
        return MAX_POINTS;
    }

    private static double along(MeasurementRing measurements, int age, double cos, double sin) {
        return measurements.x(age) * cos + measurements.y(age) * sin;
    }

    /** Returns the slope of the readings over the distance, by least squares. */
    private static double slope(MeasurementRing measurements, int points, double cos, double sin) {
        double meanAlong = 0;
        double meanReading = 0;
        for (int i = 0; i < points; i++) {
            meanAlong += along(measurements, i, cos, sin) / points;
            meanReading += measurements.reading(i) / points;
        }
        double top = 0;
        double bottom = 0;
        for (int i = 0; i < points; i++) {
            double offset = along(measurements, i, cos, sin) - meanAlong;
            top += offset * (measurements.reading(i) - meanReading);
            bottom += offset * offset;
        }
        return top / bottom;
    }
}
