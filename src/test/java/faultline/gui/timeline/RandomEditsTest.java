package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.engine.ControllerFactory;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.Await;
import faultline.gui.change.SensorReference;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskFailures;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random edits of a scenario while it runs: commands, changes of the timeline and of the sensors, undo and redo,
 * restarts and moves to other ticks. After each, the scenario and the record of its run can be saved, and the record
 * gives the same trajectory. The system property {@code faultline.edits} sets the number of sequences.
 */
class RandomEditsTest {

    private static final int SEEDS = Integer.getInteger("faultline.edits", 10);
    private static final int EDITS = 30;
    private static final int MAX_STEPS = 40;
    private static final List<String> SCENARIOS = List.of("three-visitors", "every-fault", "noisy-sensors");

    private Workspace workspace;
    private RunController run;
    private CommandSender sender;
    private UndoController undo;
    private TimelineEditor timeline;
    private SensorEditor sensors;
    private ScenarioEditor properties;
    /** The tick that the run is about to reach, -1 for none. */
    private long awaitedTick = -1;

    @BeforeEach
    void create() {
        runOnEdt(() -> {
            workspace = new Workspace();
            run = new RunController(workspace);
            sender = new CommandSender(run::send);
            undo = new UndoController(sender, () -> {});
            timeline = new TimelineEditor(workspace, run, undo, note -> {});
            properties = new ScenarioEditor(run, undo);
            sensors = new SensorEditor(workspace, properties, note -> {});
            undo.follow(workspace, run);
            workspace.addListener(new TaskFailures());
        });
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    static Stream<Integer> seeds() {
        return IntStream.range(0, SEEDS).boxed();
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void theScenarioAndTheRecordOfTheRunCanAlwaysBeSaved(int seed) throws Exception {
        Random random = new Random(seed);
        Path file = Path.of("scenarios", SCENARIOS.get(seed % SCENARIOS.size()) + ".xml");
        runOnEdt(() -> new DocumentStore(workspace).open(file));
        SessionFrames.awaitScenario(workspace);
        List<String> edits = new ArrayList<>();
        for (int i = 0; i < EDITS; i++) {
            runOnEdt(() -> edits.add(edit(random)));
            awaitRest();
            String sequence = "seed " + seed + ": " + edits;
            Scenario scenario = callOnEdt(() -> workspace.scenario().orElseThrow());
            assertDoesNotThrow(scenario::toBytes, sequence);
            Scenario record =
                    callOnEdt(() -> workspace.replayScenario().orElseThrow()).get();
            assertDoesNotThrow(record::toBytes, sequence);
            assertEquals(
                    SessionFrames.trajectoryHash(workspace),
                    HeadlessRun.run(record.setup(), ControllerMode.DIRECT, List.of())
                            .trajectoryHash(),
                    sequence);
        }
    }

    /** The robot stands still and anything may move, so no command is refused. */
    @ParameterizedTest
    @MethodSource("seeds")
    void undoingEverythingRestoresTheScenario(int seed) throws ScenarioException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        WorldSpec hall = visitors.setup().world();
        WorldSpec world = new WorldSpec(hall.width(), hall.height(), true, 100, hall.obstacles());
        SimulationSetup still = visitors.setup().withWorld(world).withController(new ControllerSpec.None());
        Scenario before = visitors.withSetup(still).withExpectation(Expectation.NONE);
        runOnEdt(() -> new DocumentStore(workspace).create(before));
        SessionFrames.awaitScenario(workspace);
        Random random = new Random(seed);
        List<String> edits = new ArrayList<>();
        for (int i = 0; i < EDITS; i++) {
            runOnEdt(() -> edits.add(setupEdit(random)));
            awaitRest();
        }
        undoAll();
        assertEquals(before, callOnEdt(() -> workspace.scenario().orElseThrow()), "seed " + seed + ": " + edits);
    }

    /** Returns the number of edits that it has undone. */
    private int undoAll() {
        int undone = 0;
        while (undone < 2 * EDITS && callOnEdt(undo::undoName).isPresent()) {
            runOnEdt(undo::undo);
            awaitRest();
            undone++;
        }
        return undone;
    }

    /** Without a restart, what is undone stays on the timeline, with what ends it. The order of the commands counts. */
    @ParameterizedTest
    @MethodSource("seeds")
    void undoingFaultsAndSwitchesAfterARestartAndRedoingThemRestoresTheScenario(int seed) {
        Path file = Path.of("scenarios", SCENARIOS.get(seed % SCENARIOS.size()) + ".xml");
        runOnEdt(() -> new DocumentStore(workspace).open(file));
        SessionFrames.awaitScenario(workspace);
        Scenario before = callOnEdt(() -> workspace.scenario().orElseThrow());
        Random random = new Random(seed);
        List<String> edits = new ArrayList<>();
        for (int i = 0; i < EDITS; i++) {
            runOnEdt(() -> edits.add(event(random)));
            awaitRest();
        }
        runOnEdt(run::restart);
        awaitRest();
        Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
        int undone = undoAll();
        assertEquals(before, callOnEdt(() -> workspace.scenario().orElseThrow()), "seed " + seed + ": " + edits);
        for (int i = 0; i < undone; i++) {
            runOnEdt(undo::redo);
            awaitRest();
        }
        assertEquals(edited, callOnEdt(() -> workspace.scenario().orElseThrow()), "seed " + seed + ": " + edits);
    }

    private String event(Random random) {
        SessionFrame frame = SessionFrames.frame(workspace);
        long tick = frame.snapshot().tick();
        undo.endEdit();
        switch (random.nextInt(10)) {
            case 0 -> run.restart();
            case 1 -> run.navigator().seek(random.nextInt((int) tick + 1));
            case 2, 3, 4 -> step(tick, random.nextInt(MAX_STEPS));
            case 5 -> editProperties(random);
            case 6 -> timeline.add(TimelineItem.from(command(frame, random), random.nextInt(60)), null);
            default -> {
                List<SensorSnapshot> sensors = frame.snapshot().sensors();
                SensorSnapshot sensor = sensors.get(random.nextInt(sensors.size()));
                String id = sensor.spec().id();
                Command event = random.nextBoolean()
                        ? new Command.SwitchSensor(id, !sensor.spec().on())
                        : sensor.faults().isEmpty()
                                ? new Command.InjectFault(id, new Fault.Stuck(random.nextInt(5) / 10.0))
                                : new Command.ClearFaults(id);
                sender.send(event);
                return tick + ": " + event;
            }
        }
        return "tick " + tick;
    }

    private String setupEdit(Random random) {
        SessionFrame frame = SessionFrames.frame(workspace);
        Command command = command(frame, random);
        undo.endEdit();
        switch (random.nextInt(13)) {
            case 0 -> undo.undo();
            case 1 -> undo.redo();
            case 2, 3, 4 -> step(frame.snapshot().tick(), random.nextInt(20 * MAX_STEPS));
            case 5 -> timeline.add(TimelineItem.from(command, random.nextInt(60)), null);
            case 6 -> editSensors(frame, random);
            case 7 -> editProperties(random);
            case 8 -> run.restart();
            case 9 -> moveItem(random);
            default -> {
                if (SensorReference.in(command).isEmpty() || command instanceof Command.ConfigureSensor) {
                    sender.send(command);
                }
                return frame.snapshot().tick() + ": " + command;
            }
        }
        return "tick " + frame.snapshot().tick();
    }

    /** Makes some ticks, which are over when {@link #awaitRest} returns. */
    private void step(long tick, int steps) {
        IntStream.range(0, steps).forEach(step -> run.step());
        awaitedTick = tick + steps;
    }

    private void awaitRest() {
        Await.until(
                "the end of the edit",
                () -> !workspace.awaitsCommands() && workspace.task().isEmpty());
        if (awaitedTick >= 0) {
            SessionFrames.awaitTick(workspace, awaitedTick);
            awaitedTick = -1;
        }
        SessionFrame frame = SessionFrames.frame(workspace);
        runOnEdt(() -> {
            sender.pendingEdits().setRobot(frame.snapshot().robot());
            undo.runAdvanced(frame.snapshot().tick());
        });
    }

    /** Makes one edit, and returns what it was. */
    private String edit(Random random) {
        SessionFrame frame = SessionFrames.frame(workspace);
        long tick = frame.snapshot().tick();
        switch (random.nextInt(14)) {
            case 0 -> undo.undo();
            case 1 -> undo.redo();
            case 2 -> run.restart();
            case 3 -> run.navigator().seek(random.nextInt((int) tick + 1));
            case 4, 5, 6 -> step(tick, random.nextInt(MAX_STEPS));
            case 7 -> timeline.add(TimelineItem.from(command(frame, random), random.nextInt(60)), null);
            case 8 -> {
                if (!timeline.model().items().isEmpty()) {
                    timeline.remove(random.nextInt(timeline.model().items().size()));
                }
            }
            case 9 -> editSensors(frame, random);
            case 10 -> editProperties(random);
            default -> {
                Command command = random.nextInt(4) == 0 ? robotCommand(random) : command(frame, random);
                undo.endEdit();
                sender.send(command);
                return command.toString();
            }
        }
        return "tick " + tick;
    }

    /** Moves an item of the timeline in some steps, which are one edit. */
    private void moveItem(Random random) {
        int items = timeline.model().items().size();
        if (items > 0) {
            int index = random.nextInt(items);
            for (int i = random.nextInt(3); i >= 0; i--) {
                TimelineItem item = timeline.model().items().get(index);
                double step = random.nextInt(5);
                timeline.replace(index, item.withTimes(item.start() + step, item.end() + step));
            }
        }
    }

    private void editSensors(SessionFrame frame, Random random) {
        List<String> ids = frame.snapshot().robot().sensorIds();
        if (ids.isEmpty() || random.nextBoolean()) {
            sensors.add();
        } else if (random.nextBoolean()) {
            sensors.rename(ids.get(random.nextInt(ids.size())), "sensor " + random.nextInt(20));
        } else {
            sensors.remove(ids.get(random.nextInt(ids.size())), restored -> {});
        }
    }

    private void editProperties(Random random) {
        Scenario open = workspace.scenario().orElseThrow();
        SimulationSetup setup = open.setup();
        List<ControllerState> states = ControllerFactory.states(setup.controller());
        Expectation expected = random.nextBoolean()
                ? open.expectation()
                : new Expectation(List.of(new Expectation.VisitedState(states.get(random.nextInt(states.size())))));
        SimulationSetup changed =
                switch (random.nextInt(5)) {
                    case 0 -> setup.withSeed(random.nextInt(9));
                    case 1 -> setup.withDuration(random.nextInt(90));
                    case 2 -> setup.withRobot(setup.robot().withTurnRate(1 + random.nextInt(3)));
                    case 3 -> setup.withTick(random.nextBoolean() ? 0.01 : 0.02);
                    default -> setup;
                };
        properties.edit(
                "edit.properties", now -> with(now, changed, expected), now -> with(now, setup, open.expectation()));
    }

    /** Returns a scenario with the seed, the duration, the tick, the turn rate and the expectation of another one. */
    private static Scenario with(Scenario scenario, SimulationSetup other, Expectation expected) {
        SimulationSetup old = scenario.setup();
        SimulationSetup changed = old.withSeed(other.seed())
                .withDuration(other.duration())
                .withTick(other.dt())
                .withRobot(old.robot().withTurnRate(other.robot().turnRate()));
        return scenario.withSetup(changed).withExpectation(expected);
    }

    private static Command robotCommand(Random random) {
        MotorSide side = random.nextBoolean() ? MotorSide.LEFT : MotorSide.RIGHT;
        ControllerSpec.WallFollowing follower = ControllerSpec.WallFollowing.DEFAULT
                .withDiagnosis(random.nextBoolean())
                .withDistance(0.2 + random.nextInt(3) / 10.0);
        return switch (random.nextInt(7)) {
            case 0 -> new Command.SetPlatform(0.1 + random.nextInt(3) / 10.0, 0.2, 0.1 + random.nextInt(3) / 10.0);
            case 1 -> new Command.ConfigureController(new ControllerSpec.None());
            case 2 -> new Command.ConfigureController(new ControllerSpec.Drive(1, random.nextInt(3)));
            case 3 -> new Command.InjectMotorFault(side, new MotorFault.Weak(0.5));
            case 4 -> new Command.ClearMotorFaults(side);
            default -> new Command.ConfigureController(follower);
        };
    }

    private static Command command(SessionFrame frame, Random random) {
        List<Obstacle> obstacles = frame.snapshot().obstacles();
        List<String> ids = frame.snapshot().robot().sensorIds();
        Obstacle obstacle = obstacles.isEmpty() || random.nextInt(4) == 0
                ? new Obstacle("new-" + random.nextInt(3), new ObstacleShape.CircleShape(0.1), pose(random))
                : obstacles.get(random.nextInt(obstacles.size()));
        String sensor = ids.isEmpty() ? "front" : ids.get(random.nextInt(ids.size()));
        return switch (ids.isEmpty() ? random.nextInt(4) : random.nextInt(8)) {
            case 0 -> new Command.MoveObstacle(obstacle.id(), pose(random));
            case 1 -> new Command.RemoveObstacle(obstacle.id());
            case 2 -> new Command.PlaceObstacle(obstacle.withPose(pose(random)));
            case 3 ->
                new Command.PlaceObstacle(obstacle.withMotion(
                        new WaypointPath(0.3, true, List.of(new Vector2(1, 3), new Vector2(2, 2)))));
            case 4 -> new Command.SwitchSensor(sensor, random.nextBoolean());
            case 5 -> new Command.InjectFault(sensor, new Fault.Stuck(0.3));
            case 6 -> new Command.ClearFaults(sensor);
            default ->
                new Command.ConfigureSensor(frame.snapshot()
                        .robot()
                        .sensor(sensor)
                        .orElseThrow()
                        .withCone(Degrees.toRadians(5 + random.nextInt(60))));
        };
    }

    private static Pose pose(Random random) {
        return new Pose(random.nextInt(60) / 10.0, 1.5 + random.nextInt(30) / 10.0, 0);
    }
}
