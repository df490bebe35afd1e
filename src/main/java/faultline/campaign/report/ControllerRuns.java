package faultline.campaign.report;

import faultline.engine.RobotPath;
import faultline.engine.metrics.RunResult;
import java.util.List;

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
     * A completed run.
     *
     * @param result its seed and its results
     * @param path the path of the robot, for pictures; it lacks points that are close to others
     * @param metres the length of the whole path, from tick to tick
     */
    public record ComparedRun(RunResult result, RobotPath path, double metres) {}

    /**
     * A run that failed.
     *
     * @param seed the seed of its random numbers
     * @param reason one sentence
     */
    public record FailedRun(long seed, String reason) {}
}
