package faultline.control.wallfollower;

import faultline.sensor.Reading;
import java.util.ArrayList;
import java.util.List;

/**
 * The rule of equal readings: F3 and F4 are taken at the same reading, the timing level, on either side of the nearest
 * one. A level nearer to the wall than the range separates the walls of a corner. Between two samples the moment is
 * interpolated.
 */
final class EqualReadingsEdgeTimer extends EdgeTimer {

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
    private double highestReading;
    private double nearest;
    private int nearestIndex;
    private double farthestSinceNearest;
    private double reversalMargin;
    private double margin;
    private double step;
    private boolean noiseKnown;

    @Override
    void start(double newMargin, double noise, boolean known, double newStep) {
        super.start(newMargin, noise, known, newStep);
        margin = newMargin;
        step = newStep;
        samples.clear();
        highestReading = -1;
        nearest = Reading.NOTHING;
        farthestSinceNearest = 0;
        noiseKnown = known;
        setNoise(known ? noise : 0);
    }

    @Override
    void updateNoise(double noise, boolean known) {
        if (!noiseKnown && known) {
            noiseKnown = true;
            setNoise(noise);
        }
    }

    private void setNoise(double noise) {
        int averaged = blockSize(noise, step);
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

    /** Adds a sample as specified, and keeps the beginning of the falling side. */
    @Override
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

    /** Returns whether the readings fall. */
    @Override
    boolean reachesWall() {
        if (samples.isEmpty() || lastSample().reading() >= highestReading - reversalMargin) {
            return false;
        }
        nearest(lastSample().reading());
        return true;
    }

    private void nearest(double reading) {
        nearest = reading;
        nearestIndex = samples.size() - 1;
        farthestSinceNearest = reading;
    }

    @Override
    void addPassSample(double clock, double reading) {
        if (average.add(clock, reading)) {
            addSample();
            if (average.reading() < nearest) {
                nearest(average.reading());
            }
            farthestSinceNearest = Math.max(farthestSinceNearest, average.reading());
        }
    }

    /** Returns whether the reading has risen again to the timing level, has passed a maximum before, or is infinite. */
    @Override
    boolean leavesWall() {
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
        setEdges(
                crossingTime(samples.get(before), samples.get(before + 1), level),
                crossingTime(samples.get(after - 1), samples.get(after), level));
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
}
