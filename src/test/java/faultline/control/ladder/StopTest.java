package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.Telemetry;
import faultline.control.WallSide;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A robot that cannot go on stops and gives the reason. */
class StopTest {

    private static RobotSpec robotWithOnly(Set<String> on) {
        List<SensorSpec> sensors = RobotSpec.DEFAULT.sensors().stream()
                .map(sensor -> sensor.withOn(on.contains(sensor.id())))
                .toList();
        return RobotSpec.DEFAULT.withSensors(sensors);
    }

    private static SimulationSetup setup(
            WorldSpec world, Pose start, RobotSpec robot, WallSide side, List<TimedCommand> timeline) {
        return new SimulationSetup(
                world, robot, start, ControllerSpec.WallFollowing.DEFAULT.withSide(side), timeline, 0.01, 1, 300);
    }

    private static Simulation run(SimulationSetup setup, double time) {
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        while (simulation.time() < time) {
            simulation.tick();
        }
        return simulation;
    }

    private static Simulation runUntilStop(SimulationSetup setup) {
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        while (simulation.time() < setup.duration() && simulation.telemetry().state() != FaultTolerantFollower.STOP) {
            simulation.tick();
        }
        return simulation;
    }

    @ParameterizedTest
    @EnumSource
    void withoutASensorOnTheWallsSideItStopsWithinTenSeconds(WallSide side) {
        Set<String> others = side == WallSide.LEFT
                ? Set.of("front", "front-right", "right", "rear")
                : Set.of("front", "front-left", "left", "rear");
        SimulationSetup setup = setup(
                new WorldSpec(5, 4, true, 3, List.of()), new Pose(2, 2, 0.4), robotWithOnly(others), side, List.of());
        Telemetry telemetry = run(setup, 10).telemetry();
        assertEquals(FaultTolerantFollower.STOP, telemetry.state());
        assertEquals("no trusted sensor on the side of the wall", telemetry.condition());
        Simulation later = run(setup, 20);
        assertEquals(0, later.velocity().linear(), 1e-9);
        assertTrue(later.collision().isEmpty());
    }

    @Test
    void roundAPoleItStopsAfterSomeSmallLapsAndContinuesWithAnotherSensor() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.05), new Pose(4, 4, 0));
        SimulationSetup setup = setup(
                new WorldSpec(8, 8, true, 3, List.of(pole)),
                new Pose(3, 4, 0.05),
                robotWithOnly(Set.of("front", "front-left", "left", "rear-left")),
                WallSide.LEFT,
                List.of(
                        new TimedCommand(4, new Command.SwitchSensor("front", false)),
                        new TimedCommand(200, new Command.SwitchSensor("left", false))));
        Simulation simulation = runUntilStop(setup);
        assertEquals("no progress", simulation.telemetry().condition());
        assertEquals("STOP", simulation.telemetry().diagnosis().rung());
        assertTrue(simulation.time() > 60 && simulation.time() < 110, "at " + simulation.time());
        double stopped = simulation.time();
        assertEquals(simulation.pose().x(), run(setup, 150).pose().x(), 0.02, "it stays where it stopped");
        assertTrue(run(setup, 210).telemetry().state() != FaultTolerantFollower.STOP, "since " + stopped);
    }

    @Test
    void aFollowerThatReplacesAnotherOneHasTimeForItsProgress() {
        ControllerSpec.WallFollowing follower = ControllerSpec.WallFollowing.DEFAULT;
        SimulationSetup setup = setup(
                new WorldSpec(6, 4, true, 3, List.of()),
                new Pose(1.2, 3, 0),
                RobotSpec.DEFAULT,
                WallSide.LEFT,
                List.of(
                        new TimedCommand(99, new Command.ConfigureController(follower.withDiagnosis(false))),
                        new TimedCommand(100, new Command.SwitchSensor("front", false)),
                        new TimedCommand(100, new Command.ConfigureController(follower))));
        assertEquals("THREE", run(setup, 101).telemetry().diagnosis().rung());
    }

    @Test
    void alongAWallItDoesNotStop() {
        SimulationSetup setup = setup(
                new WorldSpec(4, 3, true, 3, List.of()),
                new Pose(0.6, 0.6, 0.3),
                robotWithOnly(Set.of("front-left", "left", "rear-left")),
                WallSide.LEFT,
                List.of());
        assertEquals(300, runUntilStop(setup).time(), 0.02);
    }

    @ParameterizedTest
    @ValueSource(strings = {"left", "front", "front left"})
    void outOfANarrowDeadEndItDrivesOn(String failing) {
        Obstacle box = new Obstacle("box", new ObstacleShape.RectangleShape(0.9, 0.9), new Pose(3.72, 3.55, 0));
        Set<String> on = RobotSpec.DEFAULT.sensors().stream()
                .map(SensorSpec::id)
                .filter(id -> !List.of(failing.split(" ")).contains(id))
                .collect(Collectors.toSet());
        SimulationSetup setup = setup(
                new WorldSpec(5, 4, true, 3, List.of(box)),
                new Pose(0.6, 3.6, 0.1),
                robotWithOnly(on),
                WallSide.LEFT,
                List.of());
        assertEquals(300, runUntilStop(setup).time(), 0.02);
    }

    private static List<TimedCommand> switched(List<String> sensors, double off, double on) {
        List<TimedCommand> timeline = new ArrayList<>();
        sensors.forEach(id -> timeline.add(new TimedCommand(off, new Command.SwitchSensor(id, false))));
        sensors.forEach(id -> timeline.add(new TimedCommand(on, new Command.SwitchSensor(id, true))));
        return timeline;
    }

    private static SimulationSetup inARoom(List<TimedCommand> timeline) {
        return setup(
                new WorldSpec(6, 4, true, 3, List.of()),
                new Pose(1.2, 3, 0),
                RobotSpec.DEFAULT,
                WallSide.LEFT,
                timeline);
    }

    /** At rest, the sensors cannot confirm each other. */
    @ParameterizedTest
    @CsvSource({
        "front-left left rear-left, 0.01",
        "front-left left rear-left, 15",
        "front front-left left rear-left rear rear-right right front-right, 0.5",
    })
    void itDrivesOnSomeSecondsAfterItsSensorsAnswerAgain(String sensors, double silence) {
        List<TimedCommand> timeline = switched(List.of(sensors.split(" ")), 20, 20 + silence);
        assertEquals(
                "STOP", run(inARoom(timeline), 20.1).telemetry().diagnosis().rung());
        assertEquals(
                "STOP",
                run(inARoom(timeline), 22.9 + silence).telemetry().diagnosis().rung());
        Simulation trusting = run(inARoom(timeline), 23.2 + silence);
        assertEquals("ALL", trusting.telemetry().diagnosis().rung());
        Simulation later = run(inARoom(timeline), 30 + silence);
        assertTrue(trusting.pose().position().distanceTo(later.pose().position()) > 1, "it drives");
        assertTrue(run(inARoom(timeline), 100).collision().isEmpty());
    }

    @Test
    void aSensorThatIsSilentNowAndThenIsTrustedLaterEachTime() {
        List<String> sensors = List.of("front-left", "left", "rear-left");
        List<TimedCommand> timeline = new ArrayList<>(switched(sensors, 20, 21));
        timeline.addAll(switched(sensors, 30, 31));
        assertEquals(
                "STOP", run(inARoom(timeline), 36.9).telemetry().diagnosis().rung());
        assertEquals("ALL", run(inARoom(timeline), 37.2).telemetry().diagnosis().rung());
    }

    /** Returns a robot in a closed cell. Without its front sensor, it makes no progress with the local map. */
    private static SimulationSetup inACell(double speed, TimedCommand... later) {
        List<TimedCommand> timeline = new ArrayList<>();
        timeline.add(new TimedCommand(0, new Command.SwitchSensor("front", false)));
        timeline.addAll(List.of(later));
        return setup(
                new WorldSpec(0.8, 0.8, true, 3, List.of()),
                new Pose(0.4, 0.4, 0),
                RobotSpec.DEFAULT.withSpeed(speed),
                WallSide.LEFT,
                timeline);
    }

    /** The time in which the robot would drive 15 times across a square of 1.3 m. */
    @ParameterizedTest
    @CsvSource({"0.3, 65", "1, 19.5"})
    void theTimeWithoutProgressDependsOnTheSpeed(double speed, double seconds) {
        Simulation simulation = runUntilStop(inACell(speed));
        assertEquals("no progress", simulation.telemetry().condition());
        assertEquals(seconds, simulation.time(), 2);
    }

    @Test
    void aSetOfSensorsIsTriedThatIsNewAtTheTickAtWhichAnotherOneWasStuck() {
        long decision = runUntilStop(inACell(1)).ticks() - 1;
        SimulationSetup setup = inACell(
                1,
                new TimedCommand(
                        decision * SimulationSetup.DEFAULT_TICK, new Command.SwitchSensor("rear-left", false)));
        assertEquals("THREE", run(setup, 21).telemetry().diagnosis().rung());
    }
}
