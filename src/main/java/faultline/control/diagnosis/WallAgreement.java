package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * Finds the one of three sensors beside a straight wall that drifts. While the robot drives along the wall all three
 * measure the same distance of it; where one differs from two that agree, and by the same over some way, it is wrong. A
 * step of the wall, or a thing that stands at it, passes from one sensor to the next within less way.
 */
final class WallAgreement {

    /** No sensor is wrong. */
    static final int NONE = -1;

    /** Means are taken over this way, metres. */
    private static final double LEG = 0.15;

    /** The legs in which the same sensor differs. */
    private static final int LEGS = 3;

    /** Distances that differ by more are of different surfaces, or one is wrong, metres. */
    private static final double DIFFERS = 0.03;

    /** Distances that differ by less agree, metres. */
    private static final double AGREES = 0.012;

    /** The same ahead and behind: if the sensor between them drifts, the robot drives at a slant, metres. */
    private static final double AGREES_AROUND = 0.04;

    /** The most that a difference changes from one leg to the next, metres. */
    private static final double STEADY = 0.012;

    /** The most that the robot turns in a leg: beside a straight wall it drives straight, radians. */
    private static final double MAX_TURN = StrictMath.toRadians(3);

    private static final int SENSORS = 3;

    private final double[] sums = new double[SENSORS];
    /** How far the robot had rolled and turned at the beginning of the leg. */
    private double wayBefore;

    private double headingBefore;
    private int count;
    private int odd = NONE;
    private double difference;
    private int legs;

    /**
     * Takes the distances at an inspection.
     *
     * @param line the sensors
     * @param readings of all sensors
     * @param way how far the robot has rolled so far, metres
     * @param heading how far it has turned so far, radians
     * @return the sensor that is wrong, as a place in the line, or {@link #NONE}
     */
    int update(WallLine line, double[] readings, double way, double heading) {
        if (!line.isSeen(readings)) {
            beginLeg(way, heading);
            legs = 0;
            return NONE;
        }
        for (int i = 0; i < SENSORS; i++) {
            sums[i] += line.aside(i, readings);
        }
        count++;
        return Math.abs(way - wayBefore) < LEG ? NONE : endLeg(way, heading);
    }

    private void beginLeg(double way, double heading) {
        Arrays.fill(sums, 0);
        count = 0;
        wayBefore = way;
        headingBefore = heading;
    }

    private int endLeg(double way, double heading) {
        int differs = Math.abs(heading - headingBefore) > MAX_TURN ? NONE : differing();
        double by = differs == NONE ? 0 : (sums[differs] - sums[(differs + 1) % SENSORS]) / count;
        beginLeg(way, heading);
        boolean again = differs != NONE && differs == odd && Math.abs(by - difference) < STEADY;
        legs = differs == NONE ? 0 : again ? legs + 1 : 1;
        odd = differs;
        difference = by;
        return legs >= LEGS ? odd : NONE;
    }

    /** Returns the one that differs from two that agree. */
    private int differing() {
        for (int i = 0; i < SENSORS; i++) {
            double one = sums[(i + 1) % SENSORS] / count;
            double other = sums[(i + 2) % SENSORS] / count;
            double least = Math.min(one, other);
            double greatest = Math.max(one, other);
            double suspect = sums[i] / count;
            boolean agree = greatest - least < (i == WallLine.BESIDE ? AGREES_AROUND : AGREES);
            if (agree && (suspect > greatest + DIFFERS || suspect < least - DIFFERS)) {
                return i;
            }
        }
        return NONE;
    }
}
