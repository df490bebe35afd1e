package faultline.control;

import faultline.sensor.Reading;
import java.util.ArrayList;
import java.util.List;

/**
 * Times a spin past a wall: when the left sensor came to it (frame F3), when it left it (F4), and how far to turn back, t_p = t_D / 2 (eq.
 * (4) of the paper).
 *
 * <p>Both moments are taken at one and the same reading, on either side of the nearest one. Where the wall enters from nowhere and leaves
 * to nowhere that reading is the range, which is the paper's rule exactly; a level nearer to the wall keeps the walls of a corner apart.
 * Between two samples the moment is interpolated. Time is the spin clock's: it runs as fast as the robot turns, in units of the constant
 * rate, so that spinning up costs nothing.
 */
final class SpinTiming {

    /** A reading has turned round when it is this far from its extreme, metres, or five times what noise is left in it. */
    private static final double LEAST_TURN = 0.001;
    private static final double NOISE_FACTOR = 5;

    /**
     * Noisy readings are averaged over no more than this turn, radians. Between the walls of a corner of 150 degrees the reading rises by 4
     * mm over 10 degrees; a longer mean would flatten that, a shorter one would leave it in the noise.
     */
    private static final double MOST_AVERAGED = StrictMath.toRadians(5);

    private record Sample(double clock, double reading) {
    }

    private final List<Sample> samples = new ArrayList<>();
    private final SampleMean mean = new SampleMean();
    private final Timing rule;
    private double top;
    private double nearest;
    private int nearestIndex;
    private double farthestSince;
    private double turnMargin;
    private double tF3 = Double.NaN;
    private double tF4 = Double.NaN;

    SpinTiming(Timing rule) {
        this.rule = rule;
    }

    /**
     * Starts a new spin; readings are known up to some noise, metres, and come once a step of the turn, radians. By the paper's rule every
     * sample counts by itself.
     */
    void start(double noise, double step) {
        int averaged = rule == Timing.RANGE ? 1 : averaged(noise, step);
        mean.start(averaged);
        samples.clear();
        top = -1;
        nearest = Reading.NOTHING;
        farthestSince = 0;
        turnMargin = Math.max(LEAST_TURN, NOISE_FACTOR * noise / Math.sqrt(averaged));
        tF3 = Double.NaN;
        tF4 = Double.NaN;
    }

    /** As many samples as bring the noise below what counts as a turn, if that many fit. */
    private static int averaged(double noise, double step) {
        double wanted = NOISE_FACTOR * noise / LEAST_TURN;
        return (int) Math.max(1, Math.min(MOST_AVERAGED / step, Math.ceil(wanted * wanted)));
    }

    /**
     * While the sensor has not come to the wall: keeps the falling side's beginning. What the robot still rolls may bring a wall nearer by
     * as much; that is no fall.
     */
    void approach(double clock, double reading, double rolled) {
        top -= rolled;
        if (mean.completes(clock, reading)) {
            if (mean.reading() >= top) {
                top = mean.reading();
                samples.clear();
            }
            add();
        }
    }

    private void add() {
        samples.add(new Sample(mean.clock(), mean.reading()));
    }

    /** Whether the readings fall: the sensor comes to a wall. */
    boolean comesToWall() {
        if (samples.isEmpty()) {
            return false;
        }
        double last = last().reading();
        if (rule == Timing.RANGE ? top == Reading.NOTHING && last < top : last < top - turnMargin) {
            nearest(last);
            return true;
        }
        return false;
    }

    private void nearest(double reading) {
        nearest = reading;
        nearestIndex = samples.size() - 1;
        farthestSince = reading;
    }

    /** While the sensor passes the wall. */
    void pass(double clock, double reading) {
        if (mean.completes(clock, reading)) {
            add();
            if (mean.reading() < nearest) {
                nearest(mean.reading());
            }
            farthestSince = Math.max(farthestSince, mean.reading());
        }
    }

    /** Whether the reading has risen again to the level of timing, or turned round before, or is gone: then F3 and F4 are known. */
    boolean leavesWall() {
        return rule == Timing.RANGE ? leavesRange() : leavesLevel();
    }

    /** The first sample without the wall is F4, as the first with it was F3: both are late by up to one period. */
    private boolean leavesRange() {
        if (last().reading() < Reading.NOTHING) {
            return false;
        }
        tF3 = samples.get(1).clock();
        tF4 = last().clock();
        return true;
    }

    private boolean leavesLevel() {
        double level = Math.min(top, nearest + Math.max(Timing.MARGIN * nearest, 3 * turnMargin));
        double last = last().reading();
        boolean turnedRound = farthestSince - nearest > turnMargin && last < farthestSince - turnMargin;
        if (last >= level || turnedRound) {
            timeAt(Math.min(level, farthestSince));
            return true;
        }
        return false;
    }

    private Sample last() {
        return samples.get(samples.size() - 1);
    }

    private void timeAt(double level) {
        int before = nearestIndex;
        while (before > 0 && samples.get(before).reading() < level) {
            before--;
        }
        int after = nearestIndex;
        while (after < samples.size() - 1 && samples.get(after).reading() < level) {
            after++;
        }
        tF3 = crossing(samples.get(before), samples.get(before + 1), level);
        tF4 = crossing(samples.get(after - 1), samples.get(after), level);
    }

    /** When the reading was at the level between two samples: interpolated, or half way where one of them saw nothing. */
    private static double crossing(Sample one, Sample other, double level) {
        if (one.reading() == Reading.NOTHING || other.reading() == Reading.NOTHING || one.reading() == other.reading()) {
            return (one.clock() + other.clock()) / 2;
        }
        double share = (level - one.reading()) / (other.reading() - one.reading());
        return one.clock() + Math.max(0, Math.min(1, share)) * (other.clock() - one.clock());
    }

    /** Frame F3, seconds on the spin clock; not a number before it. */
    double tF3() {
        return tF3;
    }

    /** Frame F4, seconds on the spin clock; not a number before it. */
    double tF4() {
        return tF4;
    }

    /** How long to turn back from F4, seconds. */
    double tP() {
        double tD = tF4 - tF3;
        return tD / 2; // eq. (4): t_p = t_D / 2
    }
}
