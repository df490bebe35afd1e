package faultline.campaign.report;

import faultline.engine.RobotPath;
import faultline.engine.metrics.RunResult;
import java.util.List;

/**
 * The runs of one controller in one scenario.
 *
 * @param controller its name or command
 * @param runs that came to their end, in the order of their seeds
 * @param broken runs that did not
 */
public record ControllerRuns(String controller, List<ComparedRun> runs, List<Broken> broken) {

    /**
     * Creates the runs of one controller, from copies of the lists.
     *
     * @param controller its name or command
     * @param runs that came to their end, in the order of their seeds
     * @param broken runs that did not
     */
    public ControllerRuns {
        runs = List.copyOf(runs);
        broken = List.copyOf(broken);
    }

    /**
     * A run that came to its end.
     *
     * @param result its seed and what it came to
     * @param path where the robot drove
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
     * A run that broke.
     *
     * @param seed of its random numbers
     * @param reason one sentence
     */
    public record Broken(long seed, String reason) {}
}
