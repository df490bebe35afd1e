package faultline.external;

import faultline.engine.SimulationSetup;
import faultline.robot.RobotSpec;

/**
 * The description of a run that a controller receives before the run begins.
 *
 * @param program the name and version of the simulator
 * @param scenario the name of the scenario
 * @param seed the seed of all random numbers
 * @param dt the length of a tick, seconds
 * @param periodTicks the number of ticks for which a decision holds
 * @param duration the length of the run, seconds
 * @param robot the robot at the start
 */
public record RunDescription(
        String program, String scenario, long seed, double dt, long periodTicks, double duration, RobotSpec robot) {

    /**
     * {@return the description of a setup}
     *
     * @param program the name and version of the simulator
     * @param scenario the name of the scenario
     * @param setup the setup of the run
     * @param periodTicks the number of ticks for which a decision holds
     */
    public static RunDescription of(String program, String scenario, SimulationSetup setup, long periodTicks) {
        return new RunDescription(
                program, scenario, setup.seed(), setup.dt(), periodTicks, setup.duration(), setup.robot());
    }
}
