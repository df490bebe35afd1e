package faultline.campaign.report;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Observations in clusters, such as the runs of several worlds. Observations of one cluster may be correlated. A
 * repetition only adds weight to the observation that it repeats.
 */
final class ClusteredSample {

    /** Below this, the sum of the squared deviations is due to rounding. */
    private static final double NO_SPREAD = 1e-12;

    private final Map<Object, WeightedValue> observations = new HashMap<>();
    private final Map<String, Cluster> clusters = new LinkedHashMap<>();
    private int size;
    private double sum;

    private static final class Cluster {
        private int size;
        private double sum;

        private double mean() {
            return sum / size;
        }
    }

    private static final class WeightedValue {
        private final Cluster cluster;
        private final double value;
        private int count;

        private WeightedValue(Cluster cluster, double value) {
            this.cluster = cluster;
            this.value = value;
        }
    }

    /**
     * Adds an observation.
     *
     * @param identity what only repetitions of this observation have in common; they belong to the cluster of the first
     * @param cluster the key of its cluster
     * @param value its value, the same for all repetitions
     */
    void add(Object identity, String cluster, double value) {
        WeightedValue observation = observations.computeIfAbsent(
                identity, first -> new WeightedValue(clusters.computeIfAbsent(cluster, key -> new Cluster()), value));
        observation.count++;
        observation.cluster.size++;
        observation.cluster.sum += value;
        size++;
        sum += value;
    }

    /** Returns the number of observations, with repetitions. */
    int size() {
        return size;
    }

    double mean() {
        return sum / size;
    }

    /** Returns the mean of each cluster, in the order of their first observations. */
    double[] clusterMeans() {
        return clusters.values().stream().mapToDouble(Cluster::mean).toArray();
    }

    /**
     * Returns the number of independent observations whose mean is as certain as that of this sample: the number of
     * observations divided by the design effect, which is the ratio of the variance of the mean, from the sums of the
     * clusters, to that of independent observations. Because few clusters give an uncertain variance, the number is
     * multiplied by the squared ratio of the normal quantile to Student's (Korn and Graubard 1998).
     *
     * <p>The number is at least that of observations that are equal within their clusters, which is the number of
     * clusters if they are equally large. If no observations differ, it is the number of clusters.
     */
    double effectiveSize() {
        int count = clusters.size();
        double squares = observations.values().stream()
                .mapToDouble(observation -> square(observation.count * (observation.value - mean())))
                .sum();
        if (count == 1 || squares < NO_SPREAD) {
            return count;
        }
        double clusteredSquares = clusters.values().stream()
                .mapToDouble(cluster -> square(cluster.sum - cluster.size * mean()))
                .sum();
        double effect = Math.max(1, clusteredSquares / squares * count / (count - 1));
        double counts = observations.values().stream()
                .mapToDouble(observation -> square(observation.count))
                .sum();
        double certainty = square(Interval.NORMAL_QUANTILE / Interval.studentQuantile(count - 1));
        double sizes = clusters.values().stream()
                .mapToDouble(cluster -> square(cluster.size))
                .sum();
        return square(size) * Math.max(1 / sizes, certainty / (effect * counts));
    }

    private static double square(double x) {
        return x * x;
    }
}
