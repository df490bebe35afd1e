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

    /** Moments are integers; a robot gets here after 2000 km. */
    private static final double END = 2_000_000_000;

    private double ticks = START;

    void advance(double rolled, double turned, double dt) {
        ticks += METRE * Math.abs(rolled) + RADIAN * Math.abs(turned) + SECOND * dt;
    }

    /**
     * Starts again if the next moments would be too great for an integer.
     *
     * @return whether that is so; all earlier moments are then invalid
     */
    boolean restartAtEnd() {
        boolean atEnd = ticks > END;
        ticks = atEnd ? START : ticks;
        return atEnd;
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
