package faultline.campaign.report;

import faultline.engine.RobotPath;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Vector2;
import faultline.scenario.RunSummary;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;

/**
 * The runs of one controller in one scenario.
 *
 * @param controller its name or command
 * @param runs the runs that were completed, in the order of their seeds
 * @param broken the runs that failed
 */
public record ControllerRuns(String controller, List<ComparedRun> runs, List<FailedRun> broken) {

    /**
     * Creates the runs of one controller, from copies of the lists.
     *
     * @param controller its name or command
     * @param runs the runs that were completed, in the order of their seeds
     * @param broken the runs that failed
     */
    public ControllerRuns {
        runs = List.copyOf(runs);
        broken = List.copyOf(broken);
    }

    /**
     * What is compared of a completed run. Its memory is small, because there may be thousands.
     *
     * @param seed the seed of its random numbers
     * @param coverageOrNaN the followed share of the wall that could be followed, in [0, 1]; NaN if it is not known
     * @param distanceRmsOrNaN the distance error on straight walls, metres, root mean square; NaN if none was followed
     * @param collided whether the robot collided
     * @param finalState the name of the controller's last state
     * @param trajectoryHash the trajectory hash of all ticks, as it is written
     * @param refusals the refused commands of the timeline, one sentence each, in order
     * @param path the path of the robot as it is drawn; empty if it is not drawn
     * @param metres the length of the whole path, from tick to tick
     */
    public record ComparedRun(
            long seed,
            double coverageOrNaN,
            double distanceRmsOrNaN,
            boolean collided,
            String finalState,
            String trajectoryHash,
            List<String> refusals,
            List<Vector2> path,
            double metres) {

        /**
         * Creates a run from copies of its lists.
         *
         * @param seed the seed of its random numbers
         * @param coverageOrNaN the followed share of the wall that could be followed, in [0, 1]; NaN if it is not known
         * @param distanceRmsOrNaN the distance error on straight walls, metres, root mean square; NaN if none was
         *     followed
         * @param collided whether the robot collided
         * @param finalState the name of the controller's last state
         * @param trajectoryHash the trajectory hash of all ticks, as it is written
         * @param refusals the refused commands of the timeline, one sentence each, in order
         * @param path the path of the robot as it is drawn; empty if it is not drawn
         * @param metres the length of the whole path, from tick to tick
         */
        public ComparedRun {
            refusals = List.copyOf(refusals);
            path = List.copyOf(path);
        }

        /**
         * {@return a run with as much of its path as is drawn}
         *
         * @param result its seed and its results
         * @param path the path of the robot
         * @param metres the length of the whole path, from tick to tick
         * @param first the setup of the run with the first seed
         */
        public static ComparedRun of(RunResult result, RobotPath path, double metres, SimulationSetup first) {
            boolean drawn = result.seed() - first.seed() < ComparisonChart.MAX_DRAWN;
            return of(result, drawn ? ComparisonChart.drawnPath(path, first.world()) : List.of(), metres);
        }

        /** Returns the results that do not depend on readings, for comparisons to the last bit. */
        private List<Object> results() {
            return List.of(coverageOrNaN, distanceRmsOrNaN, collided, finalState, metres);
        }

        /** Returns a run with a path as it is drawn, empty if it is not drawn. */
        static ComparedRun of(RunResult result, List<Vector2> path, double metres) {
            return new ComparedRun(
                    result.seed(),
                    result.coverageOrNaN(),
                    result.distanceRmsOrNaN(),
                    result.collision().isPresent(),
                    result.finalState().name(),
                    RunSummary.formatHash(result),
                    result.refusals(),
                    path,
                    metres);
        }
    }

    /** A run of this controller, and the run of another one with the same seed. */
    record RunPair(ComparedRun own, ComparedRun other) {}

    /** Returns the completed runs whose seed another controller has completed, too, in the order of their seeds. */
    List<RunPair> pairs(ControllerRuns other) {
        Map<Long, ComparedRun> partners = new HashMap<>();
        other.runs.forEach(run -> partners.put(run.seed(), run));
        return runs.stream()
                .filter(run -> partners.containsKey(run.seed()))
                .map(run -> new RunPair(run, partners.get(run.seed())))
                .toList();
    }

    /**
     * Returns whether several completed runs have equal results, among them the length of the path to the last bit, so
     * that they tell no more than one run. Their trajectory hashes may differ, by the noise of sensors that the
     * controller does not use.
     */
    boolean areAllEqual() {
        return runs.size() > 1
                && runs.stream().map(ComparedRun::results).distinct().count() == 1;
    }

    /** Returns whether several completed runs have one trajectory and equal readings: nothing in them is random. */
    boolean haveOneTrajectory() {
        return runs.size() > 1
                && runs.stream().map(ComparedRun::trajectoryHash).distinct().count() == 1;
    }

    /** Returns the completed runs whose paths are drawn. */
    List<ComparedRun> drawnRuns() {
        return runs.stream().filter(run -> !run.path().isEmpty()).toList();
    }

    /** Returns the completed runs that count: one of them if all are equal, otherwise all. */
    List<ComparedRun> countedRuns() {
        return areAllEqual() ? runs.subList(0, 1) : runs;
    }

    /** Returns the pairs that count: one of them if the runs of both controllers are all equal, otherwise all. */
    List<RunPair> countedPairs(ControllerRuns other) {
        List<RunPair> pairs = pairs(other);
        return areAllEqual() && other.areAllEqual() && !pairs.isEmpty() ? pairs.subList(0, 1) : pairs;
    }

    /** {@return one sentence for each command of the timeline that was refused in some of the completed runs} */
    public List<String> refusals() {
        Map<String, Integer> counts = new LinkedHashMap<>();
        for (ComparedRun run : runs) {
            new LinkedHashSet<>(run.refusals()).forEach(refusal -> counts.merge(refusal, 1, Integer::sum));
        }
        return counts.entrySet().stream()
                .map(refused -> "refused " + refused.getKey()
                        + (refused.getValue() < runs.size()
                                ? " (in " + refused.getValue() + " of " + runs.size() + " runs)"
                                : ""))
                .toList();
    }

    /**
     * A run that failed.
     *
     * @param seed the seed of its random numbers
     * @param reason one sentence
     */
    public record FailedRun(long seed, String reason) {}
}
