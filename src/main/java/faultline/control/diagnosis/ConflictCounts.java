package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * Counts how often each pair of sensors contradicted each other recently, and each sensor itself. Counts decay, so that
 * a contradiction that does not recur is forgotten.
 */
final class ConflictCounts {

    /**
     * The maximum that one pair may contribute: two sensors that contradict only each other are not distrusted at once.
     */
    private static final double MAX_PAIR_COUNT = 6;

    /** The maximum of the contradictions of a sensor with itself. */
    private static final double MAX_SELF_COUNT = 20;

    private static final double NEGLIGIBLE = 0.01;

    private final int sensors;
    private final double[] counts;
    /** For each sensor, whether any of its counts is not negligible. */
    private final boolean[] active;

    ConflictCounts(int sensors) {
        this.sensors = sensors;
        this.counts = new double[sensors * sensors];
        this.active = new boolean[sensors];
    }

    void add(int one, int other, double weight) {
        increase(one, other, weight);
        if (one != other) {
            increase(other, one, weight);
        }
    }

    private void increase(int one, int other, double weight) {
        int i = one * sensors + other;
        active[one] = true;
        counts[i] = Math.min(one == other ? MAX_SELF_COUNT : MAX_PAIR_COUNT, counts[i] + weight);
    }

    /** Reduces all counts of one sensor. */
    void fade(int sensor, double share) {
        if (!active[sensor]) {
            return;
        }
        double most = 0;
        for (int i = sensor * sensors; i < (sensor + 1) * sensors; i++) {
            counts[i] *= share;
            most = Math.max(most, counts[i]);
        }
        if (most < NEGLIGIBLE) {
            Arrays.fill(counts, sensor * sensors, (sensor + 1) * sensors, 0);
            active[sensor] = false;
        }
    }

    /** Forgets how often a sensor contradicted itself. */
    void clearSelf(int sensor) {
        counts[sensor * sensors + sensor] = 0;
    }

    /** Returns whether any count of a sensor is not negligible. */
    boolean isActive(int sensor) {
        return active[sensor];
    }

    /** Returns the count against a sensor: contradictions by itself and by the other sensors of a mask. */
    double against(int sensor, int others) {
        double sum = counts[sensor * sensors + sensor];
        for (int other = 0; other < sensors; other++) {
            if (other != sensor && (others >> other & 1) != 0) {
                sum += counts[sensor * sensors + other];
            }
        }
        return sum;
    }

    /** Returns whether two sensors contradict each other often enough to matter. */
    boolean isDisagreement(int one, int other) {
        return one != other && pair(one, other) > MAX_PAIR_COUNT - 1;
    }

    double pair(int one, int other) {
        return counts[one * sensors + other];
    }
}
