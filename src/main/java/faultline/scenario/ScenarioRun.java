package faultline.scenario;

import faultline.control.ControllerState;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.io.MessageText;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.Allowed;
import faultline.sensor.Reading;
import faultline.world.Collision;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A finished run of a scenario with a record of every tick, for the assertions of a test. */
public final class ScenarioRun {

    private final Scenario scenario;
    private final RunResult result;
    /** The ticks in order; one with eight sensors takes about 200 bytes. */
    private final List<LoggedTick> ticks;

    /**
     * A tick: the pose of the robot, the controller's state, and the true and the reported reading of each sensor in
     * turn, encoded as in {@link Reading}.
     */
    private record LoggedTick(Pose pose, String state, double[] readings) {

        static LoggedTick of(Simulation simulation) {
            double[] readings = new double[2 * simulation.robot().sensors().size()];
            for (int i = 0; i < readings.length; i += 2) {
                readings[i] = simulation.trueReading(i / 2);
                readings[i + 1] = simulation.reportedReading(i / 2);
            }
            return new LoggedTick(
                    simulation.pose(), simulation.telemetry().state().name(), readings);
        }
    }

    private ScenarioRun(Scenario scenario, RunResult result, List<LoggedTick> ticks) {
        this.scenario = scenario;
        this.result = result;
        this.ticks = ticks;
    }

    /** Runs a scenario to its duration; the trajectory is the same in every mode. */
    static ScenarioRun execute(Scenario scenario, ControllerMode mode) {
        List<LoggedTick> ticks = new ArrayList<>();
        RunResult result =
                HeadlessRun.run(scenario.setup(), mode, List.of(simulation -> ticks.add(LoggedTick.of(simulation))));
        return new ScenarioRun(scenario, result, ticks);
    }

    /** {@return the result, as in the summary of the command line} */
    public RunResult result() {
        return result;
    }

    /**
     * {@return the robot's pose at a time; its heading is not normalised}
     *
     * @param seconds the time, in [0, duration], rounded up to the next tick
     * @throws IllegalArgumentException if the run does not include the time
     */
    public Pose poseAt(double seconds) {
        return tickAt(seconds).pose;
    }

    /**
     * {@return the name of the controller's state at a time, such as FOLLOW}
     *
     * @param seconds the time, in [0, duration], rounded up to the next tick
     * @throws IllegalArgumentException if the run does not include the time
     */
    public String stateAt(double seconds) {
        return tickAt(seconds).state;
    }

    /**
     * {@return a sensor's reading without noise and faults at a time}
     *
     * @param sensor the id
     * @param seconds the time, in [0, duration], rounded up to the next tick
     * @throws IllegalArgumentException if the run does not include the time, or the robot does not have the sensor
     */
    public Reading trueReading(String sensor, double seconds) {
        return new Reading(tickAt(seconds).readings[2 * sensorIndex(sensor)]);
    }

    /**
     * {@return a sensor's reported reading, with noise and faults, at a time}
     *
     * @param sensor the id
     * @param seconds the time, in [0, duration], rounded up to the next tick
     * @throws IllegalArgumentException if the run does not include the time, or the robot does not have the sensor
     */
    public Reading reading(String sensor, double seconds) {
        return new Reading(tickAt(seconds).readings[2 * sensorIndex(sensor) + 1]);
    }

    /** {@return the names of all states that the controller passed through, in the order of their first appearance} */
    public List<String> states() {
        return result.visitedStates().stream().map(ControllerState::name).toList();
    }

    /** {@return the robot's first collision, if there was one} */
    public Optional<Collision> collision() {
        return result.collision();
    }

    /**
     * {@return the followed share of the wall that could be followed, in [0, 1]; empty if no wall was followed or its
     * path is too long}
     */
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

    private LoggedTick tickAt(double seconds) {
        long tick = scenario.setup().tickAt(seconds);
        if (!(seconds >= 0 && tick <= result.ticks())) {
            throw new IllegalArgumentException(
                    "there is no " + seconds + " s in a run of " + result.simulatedSeconds() + " s");
        }
        return ticks.get((int) tick);
    }

    private int sensorIndex(String sensor) {
        RobotSpec robot = scenario.setup().robot();
        int index = robot.indexOf(sensor);
        if (index < 0) {
            List<String> ids = robot.sensorIds();
            throw new IllegalArgumentException(
                    "the robot has no sensor " + MessageText.quoted(sensor) + ", only " + Allowed.names(ids, sensor));
        }
        return index;
    }
}
