package faultline.control;

import faultline.robot.RobotSpec;

/** Starts a controller that is not part of the program, once for each run. */
public interface ControllerSource {

    /**
     * A run that is about to begin.
     *
     * @param seed the seed of all random numbers
     * @param dt the length of a tick, seconds
     * @param periodTicks the number of ticks for which a decision holds
     * @param duration the duration of the run, seconds
     * @param robot the robot as the controller believes it to be, as in observations
     */
    record RunConditions(long seed, double dt, long periodTicks, double duration, RobotSpec robot) {}

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
