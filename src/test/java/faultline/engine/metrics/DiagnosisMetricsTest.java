package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.control.Telemetry;
import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.sensor.SignalFault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.LongFunction;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How long a fault could be seen, and how wrong the sensor was, until the diagnosis found it. */
class DiagnosisMetricsTest {

    private static final double ONSET = 20;

    private SimulationSetup office;

    @BeforeEach
    void read() throws ScenarioException {
        office = Scenario.load(Path.of("scenarios/office.xml")).setup().withDuration(80);
    }

    private DiagnosisMetrics run(String sensor, Fault fault) {
        SimulationSetup setup = office.withTimeline(
                List.of(new SimulationSetup.TimedCommand(ONSET, new Command.InjectFault(sensor, fault))));
        DiagnosisMetrics metrics = new DiagnosisMetrics(setup);
        HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(metrics));
        return metrics;
    }

    @Test
    void theErrorOfADriftBesideAWallGrowsUntilItIsDetected() {
        DiagnosisMetrics metrics = run("left", new SignalFault.Drift(0.01));
        double delay = metrics.detectionDelay().orElseThrow();
        assertEquals(delay + office.dt(), metrics.secondsInView().orElseThrow(), 1e-9, "both ticks are included");
        assertEquals(0.01 * delay, metrics.errorBeforeDetection().orElseThrow(), 1e-9);
        assertTrue(delay > 1, "a small error cannot be detected: " + delay);
    }

    @Test
    void aSensorThatIsOffHasNoWrongReading() {
        DiagnosisMetrics metrics = run("left", new Fault.Dead());
        assertEquals(0, metrics.errorBeforeDetection().orElseThrow());
    }

    @Test
    void onlyTheTimeWithASurfaceInRangeCounts() {
        DiagnosisMetrics metrics = run("front", new Fault.Bias(0.15));
        double delay = metrics.detectionDelay().orElseThrow();
        assertTrue(metrics.secondsInView().orElseThrow() < delay - 1, "the front sensor sees nothing beside a wall");
        assertEquals(0.15, metrics.errorBeforeDetection().orElseThrow(), 1e-12);
    }

    @Test
    void withoutADetectionThereAreNoSuchMeasures() {
        DiagnosisMetrics metrics = run("left", new Fault.Bias(0.0001));
        assertTrue(metrics.detectionDelay().isEmpty());
        assertTrue(metrics.secondsInView().isEmpty());
        assertTrue(metrics.errorBeforeDetection().isEmpty());
    }

    /** Returns the metrics of a run of 20 ticks whose diagnosis is given by the tick of the observation. */
    private static DiagnosisMetrics observe(SimulationSetup setup, LongFunction<List<SensorHealth>> diagnosis) {
        DiagnosisMetrics metrics = new DiagnosisMetrics(setup);
        Controller controller = observation -> new Decision(
                0,
                0,
                new Telemetry(
                        FollowerState.SEARCH,
                        "",
                        0,
                        0,
                        Telemetry.WallControl.NONE,
                        Telemetry.EdgeTimes.NONE,
                        new Telemetry.Diagnosis("ALL", diagnosis.apply(observation.tick()))));
        try (Simulation simulation = new Simulation(setup, controller, ControllerMode.DIRECT, CommandListener.NONE)) {
            metrics.observe(simulation);
            for (int tick = 1; tick <= 20; tick++) {
                simulation.tick();
                metrics.observe(simulation);
            }
        }
        return metrics;
    }

    private static List<SensorHealth> trusted(String sensor) {
        return List.of(SensorHealth.trusted(sensor));
    }

    private static SensorHealth distrusted(String sensor) {
        return new SensorHealth(sensor, SensorTrust.DISTRUSTED, SensorFinding.STUCK, 1, 0);
    }

    /** The first fault is that of {@code left} at 0.05 s, and {@code rear} is switched off. */
    private SimulationSetup twoFaults() {
        return office.withTimeline(List.of(
                new SimulationSetup.TimedCommand(0.1, new Command.InjectFault("right", new Fault.Dead())),
                new SimulationSetup.TimedCommand(0.01, new Command.SwitchSensor("rear", false)),
                new SimulationSetup.TimedCommand(0.05, new Command.InjectFault("left", new Fault.Bias(0.1)))));
    }

    @Test
    void aSensorWithoutAFaultThatIsNotTrustedOnceIsAFalseAlarm() {
        List<SensorHealth> some = List.of(SensorHealth.trusted("front-left"), distrusted("front"), distrusted("rear"));
        DiagnosisMetrics metrics = observe(twoFaults(), tick -> tick == 2 ? some : List.of());
        assertEquals(OptionalInt.of(1), metrics.falseAlarms(), "front; rear is switched off");
        assertEquals(
                OptionalInt.empty(), observe(twoFaults(), tick -> List.of()).falseAlarms());
    }

    /** The decision on observation 4 acts at tick 5, before the diagnosis has seen a reading with the fault. */
    @Test
    void aSensorThatIsNotTrustedBeforeItsFaultIsAFalseAlarm() {
        for (int tick = 2; tick < 12; tick++) {
            int only = tick;
            DiagnosisMetrics left =
                    observe(twoFaults(), observed -> observed == only ? List.of(distrusted("left")) : trusted("left"));
            DiagnosisMetrics right = observe(
                    twoFaults(), observed -> observed == only ? List.of(distrusted("right")) : trusted("right"));
            assertEquals(OptionalInt.of(tick <= 4 ? 1 : 0), left.falseAlarms(), "tick " + tick);
            assertEquals(OptionalInt.of(tick <= 9 ? 1 : 0), right.falseAlarms(), "tick " + tick);
            assertEquals(tick > 4, left.detectionDelay().isPresent(), "tick " + tick);
        }
    }

    /** The decision on observation 7 acts at tick 8. */
    @Test
    void theDelayIsThatOfTheFirstFault() {
        List<SensorHealth> right = List.of(distrusted("right"));
        List<SensorHealth> left = List.of(distrusted("left"));
        assertEquals(
                0.03,
                observe(twoFaults(), tick -> tick >= 7 ? left : right)
                        .detectionDelay()
                        .orElseThrow(),
                1e-9);
    }

    @Test
    void aDistrustThatBeganBeforeTheFaultDoesNotDetectIt() {
        DiagnosisMetrics always = observe(twoFaults(), tick -> List.of(distrusted("left")));
        assertEquals(OptionalDouble.empty(), always.detectionDelay());
        assertEquals(OptionalDouble.empty(), always.secondsInView());
        assertEquals(OptionalDouble.empty(), always.errorBeforeDetection());
        assertEquals(OptionalInt.of(1), always.falseAlarms());
        DiagnosisMetrics twice =
                observe(twoFaults(), tick -> tick == 10 ? trusted("left") : List.of(distrusted("left")));
        assertEquals(0.07, twice.detectionDelay().orElseThrow(), 1e-9, "from 0.05 s to tick 12");
        assertEquals(OptionalInt.of(1), twice.falseAlarms());
    }

    /** The product of 11 and 0.03 is less than 0.33. */
    @Test
    void theDelayStartsInTheTickOfTheFaultWhateverTheRoundingErrorOfItsTime() {
        SimulationSetup setup = office.withTick(0.03)
                .withTimeline(List.of(
                        new SimulationSetup.TimedCommand(0.33, new Command.InjectFault("left", new Fault.Dead()))));
        assertTrue(11 * setup.dt() < 0.33);
        DiagnosisMetrics metrics = observe(setup, tick -> tick < 11 ? trusted("left") : List.of(distrusted("left")));
        assertEquals(0.03, metrics.detectionDelay().orElseThrow(), 1e-9, "the first decision on a reading with it");
        assertEquals(OptionalInt.of(0), metrics.falseAlarms());
    }

    @Test
    void aFaultOfASensorThatTheRobotLacksIsNone() {
        SimulationSetup setup = office.withTimeline(
                List.of(new SimulationSetup.TimedCommand(0, new Command.InjectFault("top", new Fault.Dead()))));
        DiagnosisMetrics metrics = observe(setup, tick -> List.of(distrusted("left")));
        assertEquals(OptionalDouble.empty(), metrics.detectionDelay());
        assertEquals(OptionalInt.of(1), metrics.falseAlarms());
    }

    @Test
    void withoutAFaultEachSensorThatIsNotTrustedIsAFalseAlarm() {
        DiagnosisMetrics metrics = observe(office.withTimeline(List.of()), tick -> List.of(distrusted("left")));
        assertEquals(OptionalInt.of(1), metrics.falseAlarms());
        assertEquals(OptionalDouble.empty(), metrics.detectionDelay());
    }

    /** The diagnosis does not trust a sensor that is switched on again until it has agreed with others for a time. */
    @Test
    void aSensorThatIsSwitchedOffAndOnAgainIsNoFalseAlarm() {
        SimulationSetup setup = office.withTimeline(List.of(
                new SimulationSetup.TimedCommand(5, new Command.SwitchSensor("right", false)),
                new SimulationSetup.TimedCommand(8, new Command.SwitchSensor("right", true))));
        DiagnosisMetrics metrics = new DiagnosisMetrics(setup);
        HeadlessRun.run(setup.withDuration(20), ControllerMode.DIRECT, List.of(metrics));
        assertEquals(OptionalInt.of(0), metrics.falseAlarms());
    }

    /** The sensor is off at ticks 4 to 7, and the decision on observation 8 acts at tick 9. */
    @Test
    void aSensorThatIsNotTrustedAfterItWasOnAgainIsAFalseAlarm() {
        SimulationSetup setup = office.withTimeline(List.of(
                new SimulationSetup.TimedCommand(0.04, new Command.SwitchSensor("right", false)),
                new SimulationSetup.TimedCommand(0.08, new Command.SwitchSensor("right", true))));
        for (int tick = 1; tick < 12; tick++) {
            int first = tick;
            DiagnosisMetrics metrics =
                    observe(setup, observed -> observed >= first ? List.of(distrusted("right")) : trusted("right"));
            assertEquals(OptionalInt.of(tick >= 3 && tick <= 7 ? 0 : 1), metrics.falseAlarms(), "tick " + tick);
        }
        DiagnosisMetrics twice =
                observe(setup, tick -> tick >= 5 && tick != 10 ? List.of(distrusted("right")) : trusted("right"));
        assertEquals(OptionalInt.of(1), twice.falseAlarms(), "trusted in between");
    }

    /** An obstacle strikes the robot in tick 5, and the diagnosis of its readings acts from tick 6 on. */
    private SimulationSetup struck(Command... commands) {
        Vector2 robot = office.start().position();
        Vector2 ahead = Vector2.direction(office.start().heading());
        Vector2 ball = robot.plus(ahead.times(office.robot().length() / 2 + 0.065));
        Obstacle obstacle = new Obstacle(
                "ball",
                new ObstacleShape.CircleShape(0.02),
                new Pose(ball.x(), ball.y(), 0),
                new WaypointPath(1, false, List.of(robot)));
        List<SimulationSetup.TimedCommand> timeline = new ArrayList<>();
        timeline.add(new SimulationSetup.TimedCommand(0, new Command.PlaceObstacle(obstacle)));
        for (Command command : commands) {
            timeline.add(new SimulationSetup.TimedCommand(0.02, command));
        }
        return office.withTimeline(timeline);
    }

    @Test
    void whatFollowsAContactIsNoFalseAlarm() {
        for (int tick = 2; tick < 12; tick++) {
            int only = tick;
            DiagnosisMetrics metrics =
                    observe(struck(), observed -> observed == only ? List.of(distrusted("left")) : trusted("left"));
            assertEquals(OptionalInt.of(tick <= 4 ? 1 : 0), metrics.falseAlarms(), "tick " + tick);
        }
    }

    @Test
    void whatFollowsAContactDetectsNoFault() {
        SimulationSetup setup = struck(new Command.InjectFault("left", new Fault.Bias(0.1)));
        for (int tick = 2; tick < 12; tick++) {
            int first = tick;
            DiagnosisMetrics metrics =
                    observe(setup, observed -> observed >= first ? List.of(distrusted("left")) : trusted("left"));
            assertEquals(tick <= 4, metrics.detectionDelay().isPresent(), "tick " + tick);
            assertEquals(tick <= 4, metrics.secondsInView().isPresent(), "tick " + tick);
        }
    }

    @Test
    void afterAContactTheRungIsStillTheLastOne() {
        DiagnosisMetrics metrics = observe(struck(), tick -> tick < 8 ? List.of() : trusted("left"));
        assertEquals("ALL", metrics.rung());
        assertEquals(OptionalInt.of(0), metrics.falseAlarms(), "there is a diagnosis");
    }

    /** It is so in tick 10, after the first fault, which lasts from 0.05 to 0.08 s, and before the second one. */
    @Test
    void aSensorThatIsNotTrustedBetweenItsFaultsIsNoFalseAlarm() {
        Fault first = new Fault.Bias(0.1);
        SimulationSetup setup = office.withTimeline(List.of(
                new SimulationSetup.TimedCommand(0.15, new Command.InjectFault("left", new Fault.Dead())),
                new SimulationSetup.TimedCommand(0.08, new Command.ClearFault("left", first)),
                new SimulationSetup.TimedCommand(0.05, new Command.InjectFault("left", first))));
        DiagnosisMetrics metrics = observe(setup, tick -> tick == 9 ? List.of(distrusted("left")) : trusted("left"));
        assertEquals(OptionalInt.of(0), metrics.falseAlarms());
        assertEquals(0.05, metrics.detectionDelay().orElseThrow(), 1e-9, "from 0.05 s to tick 10");
    }
}
