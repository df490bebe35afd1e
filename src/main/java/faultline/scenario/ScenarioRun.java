package faultline.scenario;

import faultline.control.ControllerState;
import faultline.engine.ControllerMode;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.sensor.Reading;
import faultline.world.Collision;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A finished run of a scenario, every tick of it recorded: what a test asserts on. */
public final class ScenarioRun {

    private final Scenario scenario;
    private final RunResult result;
    private final TickLog log;

    private ScenarioRun(Scenario scenario, RunResult result, TickLog recorder) {
        this.scenario = scenario;
        this.result = result;
        this.log = recorder;
    }

    /**
     * Runs a scenario to its duration.
     *
     * @param scenario what to run
     * @param mode where the controller runs; the trajectory is the same
     * @return the recorded run
     */
    static ScenarioRun execute(Scenario scenario, ControllerMode mode) {
        TickLog recorder = new TickLog();
        RunResult result = HeadlessRun.run(scenario.setup(), mode, List.of(recorder));
        return new ScenarioRun(scenario, result, recorder);
    }

    /**
     * What the run came to, as the command line's summary has it.
     *
     * @return the result
     */
    public RunResult result() {
        return result;
    }

    /**
     * The robot's pose at a time.
     *
     * @param seconds from 0 to the run's end; the first tick that is not before it counts
     * @return metres and radians, the heading not normalised
     */
    public Pose poseAt(double seconds) {
        return log.pose(tickAt(seconds));
    }

    /**
     * The controller's state at a time.
     *
     * @param seconds from 0 to the run's end
     * @return its name, such as FOLLOW
     */
    public String stateAt(double seconds) {
        return log.state(tickAt(seconds));
    }

    /**
     * What was really in a sensor's cone at a time.
     *
     * @param sensor its id
     * @param seconds from 0 to the run's end
     * @return the reading without noise and faults
     */
    public Reading trueReading(String sensor, double seconds) {
        return log.trueReading(tickAt(seconds), sensor);
    }

    /**
     * What a sensor reported at a time.
     *
     * @param sensor its id
     * @param seconds from 0 to the run's end
     * @return the reading with noise and faults
     */
    public Reading reading(String sensor, double seconds) {
        return log.reportedReading(tickAt(seconds), sensor);
    }

    /**
     * All states that the controller passed through.
     *
     * @return in the order of their first appearance
     */
    public List<String> states() {
        return result.visitedStates().stream().map(ControllerState::name).toList();
    }

    /**
     * The robot's first contact.
     *
     * @return empty where there was none
     */
    public Optional<Collision> collision() {
        return result.collision();
    }

    /**
     * How much of the wall that could be followed was.
     *
     * @return in [0, 1], empty where no wall was followed
     */
    public OptionalDouble coverage() {
        return result.coverage();
    }

    /**
     * The hash over all ticks, which is the same for every run of the same scenario.
     *
     * @return as the command line writes it: 16 hexadecimal digits
     */
    public String trajectoryHash() {
        return RunSummary.formatHash(result);
    }

    /**
     * What the scenario expects and the run did not hold.
     *
     * @return one sentence each, empty where all was held
     */
    public List<String> unmetExpectations() {
        return scenario.expectation().unmet(result);
    }

    private int tickAt(double seconds) {
        long tick = scenario.setup().tickAt(seconds);
        if (!(tick >= 0 && tick <= result.ticks())) {
            throw new IllegalArgumentException(
                    "there is no " + seconds + " s in a run of " + result.simulatedSeconds() + " s");
        }
        return (int) tick;
    }
}
