package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * Finds a drifting sensor among three that see the same straight wall. While the robot drives along the wall, all three
 * measure the same distance to it. A sensor is wrong if it differs from two that agree, by the same amount over several
 * legs of the path. A step of the wall, or an object at it, passes from one sensor to the next within a shorter
 * distance.
 */
final class WallAgreement {

    /** No sensor is wrong. */
    static final int NONE = -1;

    /** The length of path over which means are computed, metres. */
    private static final double LEG = 0.12;

    /** The number of successive legs in which the same sensor must differ. */
    private static final int LEGS = 3;

    /** The number of legs in which a part of the wall passes from the sensor ahead to the one that faces the wall. */
    private static final int STRAIGHT_LEGS = 2;

    /** If distances differ by more than this, they belong to different surfaces, or one is wrong, metres. */
    static final double DIFFERS = 0.03;

    /** Distances agree if they differ by less than this, metres. */
    private static final double AGREES = 0.012;

    /**
     * The same limit for the outer two sensors, metres. It is larger because a robot that steers by a drifting sensor
     * does not drive parallel to the wall.
     */
    private static final double AGREES_AROUND = 0.04;

    /** The maximum change of a difference from one leg to the next, metres. */
    private static final double STEADY = 0.012;

    /** The maximum turn of the robot in a leg, because beside a straight wall it drives straight, radians. */
    private static final double MAX_TURN = StrictMath.toRadians(3);

    private final double[] sums = new double[WallLine.SENSORS];
    /** The distance at the start of this leg, metres. */
    private double distanceBefore;

    private double headingBefore;
    private int count;
    private int odd = NONE;
    private double difference;
    private int legs;
    /** The number of successive legs in which all three agree. */
    private int straightLegs;
    /** The mean distance that the sensor that faces the wall measured in the last leg, metres. */
    private double wallDistance;

    /**
     * Processes the distances at a place of the path.
     *
     * @param line the sensors
     * @param readings the readings of all sensors
     * @param distance the distance that the robot has rolled so far, metres
     * @param heading the angle that it has turned so far, radians
     * @return the sensor that is wrong, as an index in the line, or {@link #NONE}
     */
    int update(WallLine line, double[] readings, double distance, double heading) {
        if (!line.isSeen(readings)) {
            restart(distance, heading);
            return NONE;
        }
        for (int i = 0; i < WallLine.SENSORS; i++) {
            sums[i] += line.aside(i, readings);
        }
        count++;
        return Math.abs(distance - distanceBefore) < LEG ? NONE : endLeg(distance, heading);
    }

    /**
     * Forgets all legs.
     *
     * @param distance the distance that the robot has rolled so far, metres
     * @param heading the angle that it has turned so far, radians
     */
    void restart(double distance, double heading) {
        beginLeg(distance, heading);
        legs = 0;
        straightLegs = 0;
    }

    /** Returns whether all three have agreed since the sensor ahead saw the part of the wall that is now beside it. */
    boolean isStraight() {
        return straightLegs >= STRAIGHT_LEGS && (count == 0 || spread() < AGREES);
    }

    /** Returns the distance from the robot's centre to the wall in the last leg, metres. */
    double wallDistance() {
        return wallDistance;
    }

    /** Returns by how much the mean distances of this leg differ, metres. */
    private double spread() {
        double least = Math.min(sums[0], Math.min(sums[1], sums[2]));
        double greatest = Math.max(sums[0], Math.max(sums[1], sums[2]));
        return (greatest - least) / count;
    }

    private void beginLeg(double distance, double heading) {
        Arrays.fill(sums, 0);
        count = 0;
        distanceBefore = distance;
        headingBefore = heading;
    }

    private int endLeg(double distance, double heading) {
        boolean turned = Math.abs(heading - headingBefore) > MAX_TURN;
        int differs = turned ? NONE : differing();
        double by = differs == NONE ? 0 : (sums[differs] - sums[(differs + 1) % WallLine.SENSORS]) / count;
        straightLegs = !turned && distance > distanceBefore && spread() < AGREES ? straightLegs + 1 : 0;
        wallDistance = sums[WallLine.BESIDE] / count;
        beginLeg(distance, heading);
        boolean again = differs != NONE && differs == odd && Math.abs(by - difference) < STEADY;
        legs = differs == NONE ? 0 : again ? legs + 1 : 1;
        odd = differs;
        difference = by;
        return legs >= LEGS ? odd : NONE;
    }

    /** Returns the sensor that differs from two that agree, or {@link #NONE}. */
    private int differing() {
        for (int i = 0; i < WallLine.SENSORS; i++) {
            double one = sums[(i + 1) % WallLine.SENSORS] / count;
            double other = sums[(i + 2) % WallLine.SENSORS] / count;
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
