package faultline.control;

import faultline.robot.RobotSpec;

/** Starts a controller that is not part of the program, once for each run. */
public interface ControllerSource {

    /**
     * A run that is about to begin.
     *
     * @param seed the seed of all random numbers
     * @param dt the length of a tick, seconds, positive
     * @param periodTicks the number of ticks for which a decision holds, at least one
     * @param duration the duration of the run, seconds, not negative
     * @param robot the robot as the controller believes it to be, as in observations
     */
    record RunConditions(long seed, double dt, long periodTicks, double duration, RobotSpec robot) {
        /**
         * Creates the conditions of a run.
         *
         * @param seed the seed of all random numbers
         * @param dt the length of a tick, seconds, positive
         * @param periodTicks the number of ticks for which a decision holds, at least one
         * @param duration the duration of the run, seconds, not negative
         * @param robot the robot as the controller believes it to be, as in observations
         * @throws IllegalArgumentException if a number is not in its range, or the robot has a drive scale
         */
        public RunConditions {
            if (!(dt > 0 && Double.isFinite(dt))) {
                throw new IllegalArgumentException("a tick must be positive: " + dt);
            }
            if (periodTicks < 1) {
                throw new IllegalArgumentException("a decision must hold for at least one tick: " + periodTicks);
            }
            if (!(duration >= 0 && Double.isFinite(duration))) {
                throw new IllegalArgumentException("the duration must not be negative: " + duration);
            }
            if (!robot.driveScale().isNone()) {
                throw new IllegalArgumentException("the robot must be as the controller believes it to be");
            }
        }
    }

    /**
     * {@return a controller for a run} One that is {@link AutoCloseable} is closed with the run.
     *
     * @param run the conditions of the run
     */
    Controller start(RunConditions run);

    /**
     * {@return whether its controllers end a run themselves if no decision comes} Others are called on a separate
     * thread, with the time limit of the simulation.
     */
    boolean limitsAnswerTime();
}
