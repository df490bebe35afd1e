package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import faultline.sensor.Reading;

/**
 * The tests that need the readings of one sensor only: whether it answers, whether its reading changes, scatters, or
 * comes and goes.
 */
final class SignalCheck {

    /**
     * A reading that stays exactly the same over a turn of this angle is stuck, radians, if unequal wheels cannot
     * explain the turn.
     */
    private static final double STUCK_TURN = StrictMath.toRadians(12);

    /**
     * The largest curvature that a robot with unequal wheels steers along a straight wall, radians per metre: wheels
     * that are larger and smaller by 5 percent, 0.17 m apart.
     */
    private static final double WHEEL_CURVATURE = 0.6;

    /** The same over this distance along the sensor's axis, metres. */
    private static final double STUCK_DISTANCE = 0.05;

    /**
     * The same while the turn of a step changes by this much in total, radians. On a steady path along a wall a healthy
     * reading may stay the same, but then nothing makes the robot steer.
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

    /** Readings this near to the range may come and go, metres. */
    private static final double NEAR_RANGE = 0.1;

    /** The maximum number of times that a reading may come or go within about a second. */
    private static final double MAX_FLIPS = 7;

    private static final double FLIP_STEP = 1 / 150.0;

    /** Smaller counts are none. */
    private static final double NEGLIGIBLE = 1e-3;

    private final MountedCone cone;
    private final double axisCos;
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
    /** Whether motion explains the last surface that came and went. */
    private boolean explained;

    private boolean quiet;
    /** Whether the counts of spikes, scatter and flips are negligible. */
    private boolean unremarkable;

    SignalCheck(MountedCone cone, MotionAccumulator motion) {
        this.cone = cone;
        this.motion = motion;
        this.hasLever = StrictMath.hypot(cone.x(), cone.y()) > MIN_LEVER;
        this.axisCos = StrictMath.cos(cone.bearing());
        this.crossing = new ConeCrossing(cone, motion);
    }

    /** Processes a reading after some motion; need not be called while it {@linkplain #isQuiet() changes nothing}. */
    SensorFinding test(double reading) {
        if (continues(reading)) {
            return unremarkable ? SensorFinding.NONE : fade();
        }
        return testAll(reading);
    }

    /** Returns whether a reading continues the last ones smoothly; if so, stores it. */
    private boolean continues(double reading) {
        double newFirst = reading - before;
        double newSecond = newFirst - first;
        // False for differences that are not numbers.
        jumped = Math.abs(newSecond) > JUMP && Math.abs(newSecond) < Reading.NOTHING;
        boolean smooth = newFirst != 0
                && Math.abs(first) <= SPIKE
                && Math.abs(newFirst) <= SPIKE
                && Math.abs(newSecond - second) <= SCATTER;
        if (smooth) {
            release();
            before = reading;
            first = newFirst;
            second = newSecond;
        }
        return smooth;
    }

    /** Returns whether a further reading that sees nothing needs no test. */
    boolean isQuiet() {
        return quiet;
    }

    /** Returns whether the last reading jumped: it differs from the extrapolation of the two before it. */
    boolean jumped() {
        return jumped;
    }

    private SensorFinding testAll(double reading) {
        if (Reading.isOff(reading)) {
            before = Double.NaN;
            quiet = false;
            return SensorFinding.OFF;
        }
        boolean stuck = isStuck(reading);
        learnCrossing(reading);
        learnSpikes(reading);
        learnScatter(reading);
        learnFlips(reading);
        before = reading;
        quiet = changesNothing();
        SensorFinding remembered = remembered();
        return stuck ? SensorFinding.STUCK : remembered;
    }

    /** Reduces the counts as the tests do for a reading that continues the last ones smoothly. */
    private SensorFinding fade() {
        spikes -= spikes * SPIKE_STEP;
        scatter -= scatter * SCATTER_STEP;
        flips -= flips * FLIP_STEP;
        return remembered();
    }

    /** Returns the finding that follows from the counts of earlier readings. */
    private SensorFinding remembered() {
        unremarkable = scatter < NEGLIGIBLE && spikes < NEGLIGIBLE && flips < NEGLIGIBLE;
        if (scatter > MAX_SCATTER || spikes > MAX_SPIKES) {
            return SensorFinding.NOISY;
        }
        return flips > MAX_FLIPS ? SensorFinding.INTERMITTENT : SensorFinding.NONE;
    }

    /** Returns whether another reading that sees nothing would change no count. */
    private boolean changesNothing() {
        return before == Reading.NOTHING
                && flips < NEGLIGIBLE
                && spikes < NEGLIGIBLE
                && scatter <= MAX_SCATTER
                && turn == 0
                && distance == 0
                && Double.isNaN(second);
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
     * Returns whether the robot steers but the reading stays the same. A sensor that resolves only coarse steps does so
     * too, so the reading must stay for twice as long as it ever did before.
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
                || Math.abs(distance * axisCos) > STUCK_DISTANCE && Math.abs(cone.bearing()) < cone.half()
                || isHeld()
                || reading < 0.001 && Math.abs(distance) + Math.abs(turn) > STUCK_DISTANCE;
    }

    /**
     * Counts a reading that is shorter than the one before it and the one after it, which agree. When an edge grazes
     * the cone, a healthy reading flickers between two distances; so each must also differ from the last short one.
     */
    private void learnSpikes(double reading) {
        boolean spike = first < -SPIKE && Math.abs(first + (reading - before)) < NO_SPIKE;
        boolean counts = spike && Math.abs(before - lastSpike) > NO_SPIKE;
        lastSpike = spike ? before : lastSpike;
        spikes += (counts && !explained ? 1 : 0) - spikes * SPIKE_STEP;
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

    /** Counts a reading that came and went, unless motion explains it. */
    private void learnFlips(double reading) {
        boolean gone = reading == Reading.NOTHING && before < cone.range() - NEAR_RANGE;
        flips += (gone && !explained ? 2 : 0) - flips * FLIP_STEP;
    }
}
