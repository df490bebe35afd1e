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
     * @param path the path of the robot
     */
    public record ComparedRun(RunResult result, RobotPath path) {

        /** Returns the length of the path, metres. */
        double metres() {
            double sum = 0;
            for (int i = 1; i < path.size(); i++) {
                sum += StrictMath.hypot(path.x(i) - path.x(i - 1), path.y(i) - path.y(i - 1));
            }
            return sum;
        }
    }

    /**
     * A run that failed.
     *
     * @param seed the seed of its random numbers
     * @param reason one sentence
     */
    public record FailedRun(long seed, String reason) {}
}
