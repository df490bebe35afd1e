package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * Predicts a surface ahead from a sensor that looks diagonally forward. During straight motion the reading of an object
 * beside the path falls by less than the cosine of the bearing of the cone's inner edge; if it falls faster, the
 * surface extends across that edge, and the rate gives its slant: R = h / cos(e - phi), so -dR/ds = cos(phi) / cos(e -
 * phi), where e is the edge's bearing and phi that of the surface's normal.
 */
final class ApproachTest {

    /** The least number of readings from which the rate is measured. */
    private static final int MIN_POINTS = 4;

    /** They are as many as cover this distance, metres. */
    private static final double WAY = 0.12;

    /** The greatest number; more are not waited for. */
    private static final int MAX_POINTS = 8;

    /** The least distance over which the rate is measured, metres. */
    private static final double MIN_WAY = 0.08;

    /** The margin by which the rate must exceed that of an object beside the path. */
    private static final double MARGIN = 0.14;

    private static final double STRAIGHT = StrictMath.toRadians(3);

    /** Beyond this distance from the path a surface need not extend to it, metres. */
    private static final double BESIDE = 0.33;

    private final MountedCone cone;
    private final double edgeSin;
    private final double edgeCos;

    ApproachTest(MountedCone cone) {
        this.cone = cone;
        double edge = Math.abs(cone.bearing()) - cone.half();
        this.edgeSin = StrictMath.sin(edge);
        this.edgeCos = StrictMath.cos(edge);
    }

    static boolean applies(MountedCone cone) {
        // Only on the side away from the wall: on the other side the wall itself comes and goes.
        double bearing = -cone.bearing();
        return bearing > cone.half() + 0.2 && bearing < 1.2;
    }

    /**
     * Returns the distance ahead of the sensor at which the surface crosses the path, metres; infinite if none is
     * predicted.
     */
    double expectedAhead(ClaimRing claims, DeadReckoning reckoning) {
        if (across(claims.reading(0)) > BESIDE) {
            return Reading.NOTHING;
        }
        double cos = reckoning.headingCos();
        double sin = reckoning.headingSin();
        double driven = 0;
        int points = 0;
        while (points < MIN_POINTS || points < MAX_POINTS && driven < WAY) {
            if (!claims.has(points)
                    || claims.reading(points) < 0
                    || Math.abs(claims.axis(points) - claims.axis(0)) > STRAIGHT) {
                return Reading.NOTHING;
            }
            driven = way(claims, 0, cos, sin) - way(claims, points, cos, sin);
            points++;
        }
        return driven < MIN_WAY ? Reading.NOTHING : ahead(-slope(claims, points, cos, sin), claims.reading(0));
    }

    /** Returns the distance of a point on the cone's inner edge from the path. */
    private double across(double reading) {
        return Math.abs(cone.y()) + reading * edgeSin;
    }

    private static double way(ClaimRing claims, int age, double cos, double sin) {
        return claims.x(age) * cos + claims.y(age) * sin;
    }

    /** Returns the slope of the last readings over the distance, by least squares. */
    private static double slope(ClaimRing claims, int points, double cos, double sin) {
        double meanWay = 0;
        double meanReading = 0;
        for (int i = 0; i < points; i++) {
            meanWay += way(claims, i, cos, sin) / points;
            meanReading += claims.reading(i) / points;
        }
        double top = 0;
        double bottom = 0;
        for (int i = 0; i < points; i++) {
            double way = way(claims, i, cos, sin) - meanWay;
            top += way * (claims.reading(i) - meanReading);
            bottom += way * way;
        }
        return top / bottom;
    }

    private double ahead(double rate, double reading) {
        if (rate < edgeCos + MARGIN) {
            return Reading.NOTHING;
        }
        // tan(phi) = (1 / rate - cos e) / sin e; the surface extends from its point on the edge to the middle of the
        // path.
        double tan = (1 / rate - edgeCos) / edgeSin;
        return reading * edgeCos + across(reading) * tan;
    }
}
