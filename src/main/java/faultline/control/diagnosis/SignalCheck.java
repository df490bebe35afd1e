package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import faultline.sensor.Reading;

/**
 * The tests that need the readings of one sensor only: whether it answers, and whether its reading changes, scatters,
 * or appears and disappears.
 */
final class SignalCheck {

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
    private final MotionAccumulator motion;
    private final StuckCheck stuckCheck;
    private final ConeCrossing crossing;
    private double before = Double.NaN;
    private double first = Double.NaN;
    private double second = Double.NaN;
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
        this.stuckCheck = new StuckCheck(cone, motion);
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
        boolean free = finding == SensorFinding.NONE && !stuckCheck.isHolding();
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
        boolean stuck = stuckCheck.test(reading, before);
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
