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

/** A finished run of a scenario with a record of every tick, for the assertions of a test. */
public final class ScenarioRun {

    private final Scenario scenario;
    private final RunResult result;
    private final TickLog log;

    private ScenarioRun(Scenario scenario, RunResult result, TickLog recorder) {
        this.scenario = scenario;
        this.result = result;
        this.log = recorder;
    }

    /** Runs a scenario to its duration; the trajectory is the same in every mode. */
    static ScenarioRun execute(Scenario scenario, ControllerMode mode) {
        TickLog recorder = new TickLog();
        RunResult result = HeadlessRun.run(scenario.setup(), mode, List.of(recorder));
        return new ScenarioRun(scenario, result, recorder);
    }

    /** {@return the result, as in the summary of the command line} */
    public RunResult result() {
        return result;
    }

    /**
     * {@return the robot's pose at a time; its heading is not normalised}
     *
     * @param seconds the time, in [0, duration], rounded up to the next tick
     */
    public Pose poseAt(double seconds) {
        return log.pose(tickAt(seconds));
    }

    /**
     * {@return the name of the controller's state at a time, such as FOLLOW}
     *
     * @param seconds the time, in [0, duration], rounded up to the next tick
     */
    public String stateAt(double seconds) {
        return log.state(tickAt(seconds));
    }

    /**
     * {@return a sensor's reading without noise and faults at a time}
     *
     * @param sensor the id
     * @param seconds the time, in [0, duration], rounded up to the next tick
     */
    public Reading trueReading(String sensor, double seconds) {
        return log.trueReading(tickAt(seconds), sensor);
    }

    /**
     * {@return a sensor's reported reading, with noise and faults, at a time}
     *
     * @param sensor the id
     * @param seconds the time, in [0, duration], rounded up to the next tick
     */
    public Reading reading(String sensor, double seconds) {
        return log.reportedReading(tickAt(seconds), sensor);
    }

    /** {@return the names of all states that the controller passed through, in the order of their first appearance} */
    public List<String> states() {
        return result.visitedStates().stream().map(ControllerState::name).toList();
    }

    /** {@return the robot's first collision, if there was one} */
    public Optional<Collision> collision() {
        return result.collision();
    }

    /** {@return the followed share of the wall that could be followed, in [0, 1]; empty if no wall was followed} */
    public OptionalDouble coverage() {
        return result.coverage();
    }

    /** {@return the hash over all ticks as 16 hexadecimal digits} It is the same for every run of the same scenario. */
    public String trajectoryHash() {
        return RunSummary.formatHash(result);
    }

    /** {@return the expectations that the run did not meet, one sentence each} */
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
