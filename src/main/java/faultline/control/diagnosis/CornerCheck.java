package faultline.control.diagnosis;

import faultline.geometry.Angles;
import faultline.sensor.Reading;

/**
 * Compares what a sensor saw ahead of the robot with the wall that is beside it after the turn in a corner. Two sensors
 * of the wall's side that measure one distance say where that wall is, and dead reckoning where the sensor was.
 */
final class CornerCheck {

    /** A claim is kept each time the robot has rolled this far, metres. */
    private static final double SPACING = 0.02;

    /** The claims that must differ. */
    private static final int LEAST_CLAIMS = 3;

    /** Distances from the robot's centre line that differ by less are of one straight wall beside it, metres. */
    private static final double AGREES = 0.012;

    /** The inspections in a row at which they do: different surfaces agree by chance at one of them. */
    private static final int LEAST_INSPECTIONS = 2;

    /** The wall is known this far behind the sensor that faces it, metres. */
    private static final double BEHIND = 0.06;

    /** The least error of a claim that counts, metres. */
    private static final double DIFFERS = 0.03;

    /** The believed turn may be wrong by this, which moves a place along the wall nearer or farther, radians. */
    private static final double TURN_ERROR = 0.08;

    /** Errors that differ by more are of another surface, metres. */
    private static final double STEADY = 0.035;

    /** Beyond this angle between the wall's normal and the cone, a claim is not compared, radians. */
    private static final double MAX_SLANT = StrictMath.toRadians(45);

    private static final double QUARTER = StrictMath.PI / 2;

    private final ClaimRing claims = new ClaimRing();
    private double keptWay = Double.NEGATIVE_INFINITY;
    private double wallSince;
    private int wallInspections;

    /**
     * Takes the newest claim of the sensor and compares the ones before with the wall beside the robot.
     *
     * @param sensor that is compared
     * @param line the sensors on the wall's side
     * @param readings of all sensors
     * @param reckoning the robot's pose
     * @param oldest moment that counts
     * @return whether the sensor measured another distance
     */
    boolean differs(InspectedSensor sensor, WallLine line, double[] readings, DeadReckoning reckoning, double oldest) {
        if (!Reading.isOff(readings[sensor.index()])) {
            keep(sensor.claims(), reckoning.way());
        }
        boolean wall = line.isStraightAhead(readings, AGREES);
        wallInspections = wall ? wallInspections + 1 : 0;
        wallSince = wallInspections > 1 ? wallSince : reckoning.way();
        return wallInspections >= LEAST_INSPECTIONS && claimsDiffer(sensor.cone(), line, readings, reckoning, oldest);
    }

    private void keep(ClaimRing newest, double way) {
        if (way - keptWay > SPACING && newest.reading(0) >= 0) {
            keptWay = way;
            claims.add(
                    newest.x(0),
                    newest.y(0),
                    newest.axis(0),
                    newest.axisCos(0),
                    newest.axisSin(0),
                    newest.reading(0),
                    newest.clock(0));
        }
    }

    /** Returns whether all claims of places where the wall is seen differ from it by the same. */
    private boolean claimsDiffer(
            MountedCone cone, WallLine line, double[] readings, DeadReckoning reckoning, double oldest) {
        double aside = line.aside(WallLine.BESIDE, readings);
        double from = wallSince - reckoning.way() - BEHIND;
        double to = line.ahead(readings);
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        double surplus = Double.POSITIVE_INFINITY;
        int count = 0;
        for (int i = 0; claims.has(i) && claims.clock(i) > oldest; i++) {
            double off = QUARTER - Angles.normalize(claims.axis(i) - reckoning.heading());
            double slant = Math.max(0, Math.abs(off) - cone.half());
            if (slant > MAX_SLANT) {
                continue;
            }
            double dx = claims.x(i) - reckoning.x();
            double dy = claims.y(i) - reckoning.y();
            double distance = aside - dy * reckoning.headingCos() + dx * reckoning.headingSin();
            double place = dx * reckoning.headingCos()
                    + dy * reckoning.headingSin()
                    + Math.copySign(distance * StrictMath.tan(slant), off);
            if (distance > 0 && place > from && place < to) {
                double error = claims.reading(i) - distance / StrictMath.cos(slant);
                least = Math.min(least, error);
                greatest = Math.max(greatest, error);
                surplus = Math.min(surplus, Math.abs(error) - DIFFERS - TURN_ERROR * Math.abs(place));
                count++;
            }
        }
        return count >= LEAST_CLAIMS && surplus > 0 && greatest - least < STEADY;
    }
}
