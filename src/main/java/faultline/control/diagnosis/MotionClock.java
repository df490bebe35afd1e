package faultline.control.diagnosis;

/**
 * A clock that runs with the robot's motion, because motion makes dead reckoning uncertain: it counts ticks for each
 * metre rolled, each radian turned and each second.
 */
final class MotionClock {

    private static final double METRE = 1000;
    private static final double RADIAN = 100;
    private static final double SECOND = 10;
    private static final double START = 1_000_000;

    private double ticks = START;

    void advance(double rolled, double turned, double dt) {
        ticks += METRE * Math.abs(rolled) + RADIAN * Math.abs(turned) + SECOND * dt;
    }

    /** Returns the moment, exactly. */
    double ticks() {
        return ticks;
    }

    /** Returns the moment as it is marked in maps. */
    int moment() {
        return (int) ticks;
    }
}
