package faultline.external;

import faultline.control.ControllerSource.RunConditions;
import faultline.engine.SimulationSetup;

/**
 * The description of a run that a controller receives before the run begins.
 *
 * @param program the name and version of the simulator
 * @param scenario the name of the scenario
 * @param conditions the conditions of the run, with the robot at the start
 */
public record RunDescription(String program, String scenario, RunConditions conditions) {

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
                program,
                scenario,
                new RunConditions(
                        setup.seed(),
                        setup.dt(),
                        periodTicks,
                        setup.duration(),
                        setup.robot().believed()));
    }
}
