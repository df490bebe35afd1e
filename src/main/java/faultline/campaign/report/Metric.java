package faultline.campaign.report;

import faultline.campaign.report.ControllerRuns.ComparedRun;
import faultline.engine.metrics.RunFacts;
import faultline.io.DecimalText;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** A number of each run by which controllers are compared. */
enum Metric {
    /** The share of the wall that was followed. */
    COVERAGE("coverage", "the share of the wall that was followed", 3, ComparedRun::coverageOrNaN),
    /** The error of the distance to straight walls. */
    DISTANCE_RMS(
            "distance_rms_m", "the distance error on straight walls, metres RMS", 4, ComparedRun::distanceRmsOrNaN),
    /** Whether the robot collided. */
    COLLISION("collision", "the share of the runs with a collision", 2, run -> run.collided() ? 1 : 0),
    /** The distance that the robot drove. */
    PATH("path_m", "the length of the path, metres", 2, ComparedRun::metres);

    private final String column;
    private final String meaning;
    private final int decimals;
    /** Returns the value for a run, NaN if it has none. */
    private final ToDoubleFunction<ComparedRun> value;

    Metric(String column, String meaning, int decimals, ToDoubleFunction<ComparedRun> value) {
        this.column = column;
        this.meaning = meaning;
        this.decimals = decimals;
        this.value = value;
    }

    /** Returns the name of its column. */
    String column() {
        return column;
    }

    /** Returns the name of the measured quantity, as shown to users. */
    String meaning() {
        return meaning;
    }

    String format(double number) {
        return DecimalText.formatFixed(number, decimals);
    }

    /** Returns a value of a run as a cell of a table, in the same form on every machine; a collision is 1.0 or 0.0. */
    String cell(double number) {
        return this == COLLISION ? DecimalText.formatFixed(number, 1) : DecimalText.format(number);
    }

    /** Returns the value for a run, empty if it has none. */
    OptionalDouble of(ComparedRun run) {
        return RunFacts.ifNumber(value.applyAsDouble(run));
    }

    /** Returns the values of those runs that have one. */
    double[] values(List<ComparedRun> runs) {
        return runs.stream().flatMapToDouble(run -> of(run).stream()).toArray();
    }

    /** Returns the 95 % interval of the mean of some values; that of a share if the values are 0 and 1. */
    Interval interval(double[] values) {
        double mean = Arrays.stream(values).average().orElse(Double.NaN);
        if (this == COLLISION) {
            return Interval.wilson(Arrays.stream(values).sum(), values.length);
        }
        double squares = Arrays.stream(values).map(x -> (x - mean) * (x - mean)).sum();
        return Interval.mean(mean, Math.sqrt(squares / Math.max(1, values.length - 1)), values.length);
    }

    /**
     * Returns the mean of the runs that have a value, with its interval if there are at least two, and their number if
     * it is not that of all runs; "none" if there are none.
     */
    String summary(List<ComparedRun> runs) {
        return summary(values(runs), runs.size());
    }

    String summary(double[] values, int runs) {
        if (values.length == 0) {
            return "none";
        }
        double mean = Arrays.stream(values).average().orElseThrow();
        String text = values.length == 1 ? format(mean) : text(mean, interval(values));
        return text + share(values.length, runs);
    }

    /** Returns the number of runs that a mean is over, empty if it is that of all runs. */
    private static String share(int counted, int all) {
        return counted == all ? "" : " (n = " + counted + ")";
    }

    /** Returns the mean difference of pairs of runs with its interval, as {@code summary} does for one controller. */
    String difference(List<ControllerRuns.RunPair> pairs) {
        List<ControllerRuns.RunPair> complete = pairs.stream()
                .filter(pair -> of(pair.own()).isPresent() && of(pair.other()).isPresent())
                .toList();
        double[] differences = complete.stream()
                .mapToDouble(
                        pair -> of(pair.own()).getAsDouble() - of(pair.other()).getAsDouble())
                .toArray();
        return this == COLLISION && differences.length > 1
                ? text(Arrays.stream(differences).average().orElseThrow(), pairedInterval(complete))
                : summary(differences, pairs.size());
    }

    private Interval pairedInterval(List<ControllerRuns.RunPair> pairs) {
        return Interval.pairedDifference(
                count(pairs, 1, 1), count(pairs, 1, 0), count(pairs, 0, 1), count(pairs, 0, 0));
    }

    /** Counts the pairs of runs with these values. */
    private double count(List<ControllerRuns.RunPair> pairs, double own, double other) {
        return pairs.stream()
                .filter(pair ->
                        of(pair.own()).getAsDouble() == own && of(pair.other()).getAsDouble() == other)
                .count();
    }

    private String text(double mean, Interval interval) {
        return format(mean) + " [" + format(interval.low()) + ", " + format(interval.high()) + "]";
    }
}
