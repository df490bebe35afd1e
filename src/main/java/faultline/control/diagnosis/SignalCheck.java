package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import faultline.sensor.Reading;

/**
 * The tests that need the readings of one sensor only: whether it answers, and whether its reading changes, scatters,
 * or appears and disappears.
 */
final class SignalCheck {

    /**
     * A sensor is stuck if its reading stays exactly the same over a turn of this angle, radians, and unequal wheels
     * cannot explain the turn.
     */
    private static final double STUCK_TURN = StrictMath.toRadians(12);

    /**
     * The largest curvature that a robot with unequal wheels steers along a straight wall, radians per metre: wheels
     * that are larger and smaller by 5 percent, 0.17 m apart.
     */
    private static final double WHEEL_CURVATURE = 0.6;

    /** A sensor is also stuck if its reading stays exactly the same over this distance along its axis, metres. */
    private static final double STUCK_DISTANCE = 0.05;

    /**
     * The rule of {@link #STUCK_DISTANCE} does not apply if the sensor may see a wall along the path, whose nearest
     * point is at a border of the cone: that is, if the point there is farther than this from the path, metres.
     */
    private static final double BESIDE = 0.15;

    /**
     * A sensor is also stuck if its reading stays exactly the same while the turns of the steps change by this much in
     * total, radians. On a steady path along a wall a healthy reading may stay the same, but then the robot does not
     * steer.
     */
    private static final double STUCK_UNSTEADINESS = 1e-5;

    /** The minimum number of steps over which the last rule applies. */
    private static final int MIN_HELD_STEPS = 20;

    /** A sensor nearer to the robot's centre may read the same distance in a turn, metres. */
    private static final double MIN_LEVER = 0.01;

    /** A third difference of readings beyond this shows noise, metres. */
    private static final double SCATTER = 0.08;

    /** A second difference beyond this is a jump, metres. */
    private static final double JUMP = 0.045;

    /** The maximum share of such differences. */
    private static final double MAX_SCATTER = 0.25;

    private static final double SCATTER_STEP = 1 / 200.0;

    /** A reading that is shorter by this than both its neighbours is a spike, metres. */
    private static final double SPIKE = 0.04;

    /** Neighbours that differ by less than this agree, metres. */
    private static final double NO_SPIKE = 0.02;

    /** The maximum number of spikes within about three seconds. */
    private static final double MAX_SPIKES = 2;

    private static final double SPIKE_STEP = 1 / 300.0;

    /** Readings this near to the range may appear and disappear, metres. */
    private static final double NEAR_RANGE = 0.1;

    /** The maximum number of times that a reading may appear or disappear within about a second. */
    private static final double MAX_FLIPS = 7;

    private static final double FLIP_STEP = 1 / 150.0;

    private final MountedCone cone;
    private final double axisCos;
    private final double leftBorderSin;
    private final double rightBorderSin;
    private final boolean hasLever;
    private final MotionAccumulator motion;
    private final ConeCrossing crossing;
    private double before = Double.NaN;
    private double first = Double.NaN;
    private double second = Double.NaN;
    private double turn;
    private double distance;
    /** The total unsteadiness of the robot while the reading stays the same, radians, and the number of steps. */
    private double held;

    private int heldSteps;
    /** The greatest total after which the reading changed. */
    private double longestHeld;

    private double scatter;
    private double lastSpike = Double.NaN;
    private double flips;
    private boolean jumped;
    private double spikes;
    /** Whether motion explains that the last surface appeared and disappeared. */
    private boolean explained;

    /** Whether a further reading that sees nothing needs no test. */
    private boolean quiet;
    /**
     * A reading needs no test if its first and second differences are at most this, metres; negative if every reading
     * needs a test.
     */
    private double smoothLimit = -1;
    /** The step to which the counts have faded. */
    private int fadedTo;

    SignalCheck(MountedCone cone, MotionAccumulator motion) {
        this.cone = cone;
        this.motion = motion;
        this.hasLever = StrictMath.hypot(cone.x(), cone.y()) > MIN_LEVER;
        this.axisCos = StrictMath.cos(cone.bearing());
        this.leftBorderSin = StrictMath.sin(cone.bearing() + cone.half());
        this.rightBorderSin = StrictMath.sin(cone.bearing() - cone.half());
        this.crossing = new ConeCrossing(cone, motion);
    }

    /**
     * Processes a reading after some motion if it needs no test: it continues the last ones smoothly, or sees nothing
     * as they did.
     *
     * @return whether that is so; if not, nothing has changed
     */
    boolean continues(double reading) {
        if (reading == Reading.NOTHING) {
            return quiet;
        }
        double newFirst = reading - before;
        double newSecond = newFirst - first;
        // False for differences that are not numbers.
        boolean smooth = newFirst != 0 && Math.abs(newFirst) <= smoothLimit && Math.abs(newSecond) <= smoothLimit;
        if (smooth) {
            before = reading;
            first = newFirst;
            second = newSecond;
        }
        return smooth;
    }

    /** Tests a reading after some motion. */
    SensorFinding test(double reading) {
        double newSecond = reading - before - first;
        // False for a difference that is not a number.
        jumped = Math.abs(newSecond) > JUMP && Math.abs(newSecond) < Reading.NOTHING;
        SensorFinding finding = Reading.isOff(reading) ? switchedOff() : testAll(reading);
        boolean free = finding == SensorFinding.NONE && heldSteps == 0;
        quiet = free && before == Reading.NOTHING && Double.isNaN(second);
        smoothLimit = free && Math.abs(first) <= SPIKE && Math.abs(second) <= SPIKE ? SPIKE : -1;
        return finding;
    }

    /** Returns whether the last tested reading jumped: it differs from the extrapolation of the two before it. */
    boolean jumped() {
        return jumped;
    }

    private SensorFinding switchedOff() {
        fade(0);
        before = Double.NaN;
        return SensorFinding.OFF;
    }

    private SensorFinding testAll(double reading) {
        boolean stuck = isStuck(reading);
        fade(1);
        learnCrossing(reading);
        learnSpikes(reading);
        learnScatter(reading);
        learnFlips(reading);
        before = reading;
        if (stuck) {
            return SensorFinding.STUCK;
        }
        if (scatter > MAX_SCATTER || spikes > MAX_SPIKES) {
            return SensorFinding.NOISY;
        }
        return flips > MAX_FLIPS ? SensorFinding.INTERMITTENT : SensorFinding.NONE;
    }

    /**
     * Reduces the counts, except that of scatter by this reading.
     *
     * @param present 1 if this reading counts, 0 if the sensor is off
     */
    private void fade(int present) {
        int untested = motion.steps() - fadedTo - 1;
        fadedTo = motion.steps();
        spikes = faded(spikes, SPIKE_STEP, untested + present);
        flips = faded(flips, FLIP_STEP, untested + present);
        if (before != Reading.NOTHING) {
            scatter = faded(scatter, SCATTER_STEP, untested);
        }
    }

    private static double faded(double count, double step, int readings) {
        return count == 0 || readings == 0 ? count : count * remaining(1 - step, readings);
    }

    private static double remaining(double share, int readings) {
        return readings == 1 ? share : StrictMath.pow(share, readings);
    }

    /** Records that the reading has changed. */
    private void release() {
        if (heldSteps > 0) {
            turn = 0;
            distance = 0;
            longestHeld = Math.max(longestHeld, held);
            held = 0;
            heldSteps = 0;
        }
    }

    /**
     * Returns whether the robot steers but the reading stays the same. The reading of a sensor that resolves only
     * coarse steps also stays the same, so it must stay for twice as long as it ever did before.
     */
    private boolean isHeld() {
        return heldSteps >= MIN_HELD_STEPS && held > Math.max(STUCK_UNSTEADINESS, 2 * longestHeld) && hasLever;
    }

    private boolean isStuck(double reading) {
        if (reading != before || reading == Reading.NOTHING) {
            release();
            return false;
        }
        turn += motion.turned();
        distance += motion.rolled();
        held += motion.unsteadiness();
        heldSteps++;
        return Math.abs(turn) > STUCK_TURN + WHEEL_CURVATURE * Math.abs(distance)
                || Math.abs(distance * axisCos) > STUCK_DISTANCE
                        && Math.abs(cone.bearing()) < cone.half()
                        && !mayBeBeside(reading)
                || isHeld()
                || reading < 0.001 && Math.abs(distance) + Math.abs(turn) > STUCK_DISTANCE;
    }

    /** Returns whether a point at a border of the cone, at the distance of a reading, is beside the path. */
    private boolean mayBeBeside(double reading) {
        return cone.y() + reading * leftBorderSin > BESIDE || cone.y() + reading * rightBorderSin < -BESIDE;
    }

    /**
     * Counts a reading that is shorter than the one before it and the one after it, which agree. When an edge grazes
     * the cone, a healthy reading flickers between two distances; so each must also differ from the last short one.
     */
    private void learnSpikes(double reading) {
        boolean spike = first < -SPIKE && Math.abs(first + (reading - before)) < NO_SPIKE;
        boolean counts = spike && Math.abs(before - lastSpike) > NO_SPIKE;
        lastSpike = spike ? before : lastSpike;
        spikes += counts && !explained ? 1 : 0;
    }

    private void learnScatter(double reading) {
        double newFirst = reading - before;
        double newSecond = newFirst - first;
        double third = Math.abs(newSecond - second);
        if (third < Reading.NOTHING) {
            scatter += ((third > SCATTER && !explained ? 1 : 0) - scatter) * SCATTER_STEP;
        }
        first = newFirst;
        second = newSecond;
    }

    /** Determines whether motion explains that a surface came into view and left it again. */
    private void learnCrossing(double reading) {
        if (reading < before - SPIKE) {
            crossing.appear(reading);
        } else if (reading > before + SPIKE) {
            explained = crossing.canDisappear(before);
        }
    }

    /** Counts a reading that appeared or disappeared, unless motion explains it. */
    private void learnFlips(double reading) {
        boolean gone = reading == Reading.NOTHING && before < cone.range() - NEAR_RANGE;
        flips += gone && !explained ? 2 : 0;
    }
}
