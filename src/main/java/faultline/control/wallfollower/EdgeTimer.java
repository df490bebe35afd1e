package faultline.control.wallfollower;

import faultline.control.TimingRule;
import faultline.sensor.Reading;
import java.util.ArrayList;
import java.util.List;

/**
 * Times a spin past a wall: when the left sensor comes to it (frame F3), when it leaves it (F4), and how long to turn
 * back, t_p = t_D / 2 (eq. (4) of the paper).
 *
 * <p>Both moments are taken at the same reading, on either side of the nearest one. If the wall comes into range and
 * leaves it again, that reading is the range, which is exactly the paper's rule; a level nearer to the wall separates
 * the walls of a corner. Between two samples the moment is interpolated. Time is that of the spin clock, which runs as
 * fast as the robot turns, in units of the constant rate, so that the result does not depend on the acceleration of the
 * spin.
 */
final class EdgeTimer {

    /**
     * Readings have passed their extreme if one differs from it by this much, metres, or by five standard deviations of
     * the remaining noise.
     */
    private static final double MIN_REVERSAL = 0.001;

    private static final double NOISE_FACTOR = 5;

    /**
     * Noisy readings are averaged over no more than this turn, radians. Between the walls of a corner of 150 degrees
     * the reading rises by 4 mm over 10 degrees; a longer mean would flatten that rise, and a shorter one would leave
     * it in the noise.
     */
    private static final double MAX_AVERAGED_TURN = StrictMath.toRadians(5);

    private record Sample(double clock, double reading) {}

    private final List<Sample> samples = new ArrayList<>();
    private final BlockAverage average = new BlockAverage();
    private final TimingRule rule;
    private double highestReading;
    private double nearest;
    private int nearestIndex;
    private double farthestSinceNearest;
    private double reversalMargin;
    private double margin;
    private double step;
    private boolean noiseKnown;
    private double tF3 = Double.NaN;
    private double tF4 = Double.NaN;

    EdgeTimer(TimingRule rule) {
        this.rule = rule;
    }

    /**
     * Starts a new spin. With the paper's rule every sample counts separately.
     *
     * @param newMargin the difference between the timing level and the nearest reading, as a share of that reading
     * @param noise the standard deviation of the readings' noise, metres
     * @param known whether the noise is known; otherwise {@link #updateNoise} sets it during the spin
     * @param newStep the turn between two readings, radians
     */
    void start(double newMargin, double noise, boolean known, double newStep) {
        margin = newMargin;
        step = newStep;
        samples.clear();
        highestReading = -1;
        nearest = Reading.NOTHING;
        farthestSinceNearest = 0;
        noiseKnown = known;
        setNoise(known ? noise : 0);
        tF3 = Double.NaN;
        tF4 = Double.NaN;
    }

    /** Sets the noise of a sensor that had seen nothing before the spin, as soon as it is known. */
    void updateNoise(double noise, boolean known) {
        if (!noiseKnown && known) {
            noiseKnown = true;
            setNoise(noise);
        }
    }

    private void setNoise(double noise) {
        int averaged = rule == TimingRule.RANGE ? 1 : blockSize(noise, step);
        average.start(averaged);
        reversalMargin = Math.max(MIN_REVERSAL, NOISE_FACTOR * noise / Math.sqrt(averaged));
    }

    /**
     * Returns the number of samples whose mean has less noise than the difference that counts as an extreme, as far as
     * possible.
     */
    private static int blockSize(double noise, double step) {
        double wanted = NOISE_FACTOR * noise / MIN_REVERSAL;
        return (int) Math.max(1, Math.min(MAX_AVERAGED_TURN / step, Math.ceil(wanted * wanted)));
    }

    /**
     * Adds a sample before the sensor has come to the wall, and keeps the beginning of the falling side. The distance
     * that the robot still rolls forwards may bring a wall nearer; this is not counted as a fall.
     */
    void addApproachSample(double clock, double reading, double rolled) {
        highestReading -= Math.max(0, rolled);
        if (average.add(clock, reading)) {
            if (average.reading() >= highestReading) {
                highestReading = average.reading();
                samples.clear();
            }
            addSample();
        }
    }

    private void addSample() {
        samples.add(new Sample(average.clock(), average.reading()));
    }

    /** Returns whether the readings fall: the sensor comes to a wall. */
    boolean reachesWall() {
        if (samples.isEmpty()) {
            return false;
        }
        double last = lastSample().reading();
        if (rule == TimingRule.RANGE
                ? highestReading == Reading.NOTHING && last < highestReading
                : last < highestReading - reversalMargin) {
            nearest(last);
            return true;
        }
        return false;
    }

    private void nearest(double reading) {
        nearest = reading;
        nearestIndex = samples.size() - 1;
        farthestSinceNearest = reading;
    }

    /** Adds a sample while the sensor passes the wall. */
    void addPassSample(double clock, double reading) {
        if (average.add(clock, reading)) {
            addSample();
            if (average.reading() < nearest) {
                nearest(average.reading());
            }
            farthestSinceNearest = Math.max(farthestSinceNearest, average.reading());
        }
    }

    /**
     * Returns whether F3 and F4 are known: the reading has risen again to the timing level, has passed a maximum
     * before, or is infinite.
     */
    boolean leavesWall() {
        return rule == TimingRule.RANGE ? leavesRange() : leavesLevel();
    }

    /**
     * Takes the first sample without the wall as F4, as the first sample with it was F3. Both are late by up to one
     * period.
     */
    private boolean leavesRange() {
        if (lastSample().reading() < Reading.NOTHING) {
            return false;
        }
        tF3 = samples.get(1).clock();
        tF4 = lastSample().clock();
        return true;
    }

    private boolean leavesLevel() {
        double level = Math.min(highestReading, nearest + Math.max(margin * nearest, 3 * reversalMargin));
        double last = lastSample().reading();
        boolean turnedRound = noiseKnown
                && farthestSinceNearest - nearest > reversalMargin
                && last < farthestSinceNearest - reversalMargin;
        if (last >= level || turnedRound) {
            interpolateEdges(Math.min(level, farthestSinceNearest));
            return true;
        }
        return false;
    }

    private Sample lastSample() {
        return samples.get(samples.size() - 1);
    }

    private void interpolateEdges(double level) {
        int before = nearestIndex;
        while (before > 0 && samples.get(before).reading() < level) {
            before--;
        }
        int after = nearestIndex;
        while (after < samples.size() - 1 && samples.get(after).reading() < level) {
            after++;
        }
        tF3 = crossingTime(samples.get(before), samples.get(before + 1), level);
        tF4 = crossingTime(samples.get(after - 1), samples.get(after), level);
    }

    /**
     * Returns when the reading was at the level between two samples: interpolated, or half way if one of them is
     * infinite.
     */
    private static double crossingTime(Sample one, Sample other, double level) {
        if (one.reading() == Reading.NOTHING
                || other.reading() == Reading.NOTHING
                || one.reading() == other.reading()) {
            return (one.clock() + other.clock()) / 2;
        }
        double share = (level - one.reading()) / (other.reading() - one.reading());
        return one.clock() + Math.max(0, Math.min(1, share)) * (other.clock() - one.clock());
    }

    /** Returns the moment of frame F3, seconds on the spin clock; not a number before it. */
    double tF3() {
        return tF3;
    }

    /** Returns the moment of frame F4, seconds on the spin clock; not a number before it. */
    double tF4() {
        return tF4;
    }

    /**
     * Returns how long to turn back from F4, seconds. It is negative if F3 and F4 lie in the part of the spin in which
     * the robot still turned to the left, as with random readings: the spin clock runs backwards there.
     */
    double tP() {
        double tD = tF4 - tF3;
        return tD / 2; // eq. (4): t_p = t_D / 2
    }
}
