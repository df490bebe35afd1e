package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random switches, faults and repairs in a run whose timeline has some as well, with undo and redo, moves, cancelled
 * ones, restarts and moves of the start. The edited scenario always leads to the run that the window shows. Without any
 * edits, also of settings, it is the first one again. The system property {@code faultline.edits} sets the number of
 * sequences.
 */
@ExtendWith(EdtChecker.class)
class RandomUndoTest {

    private static final int SEEDS = Integer.getInteger("faultline.edits", 10);
    private static final int STEPS = 40;
    private static final int MAX_TICKS = 200;
    private static final int FRONT = 0;
    private static final int LEFT = 2;
    /** Ids that sensors get, one of them the former id of another sensor. */
    private static final List<String> NEW_IDS = List.of("a", "b", "front");

    private static final List<Fault> FAULTS = List.of(new Fault.Stuck(0.3), new Fault.Bias(0.1));
    private static final MotorFault WEAK = new MotorFault.Weak(0.9);

    private final EditedRun run = new EditedRun();
    private final ScenarioEditor editor = callOnEdt(() -> new ScenarioEditor(run.controller(), run.edits()));
    private final SensorEditor sensors = callOnEdt(() -> new SensorEditor(run.workspace(), editor, note -> {}));
    private final List<String> steps = new ArrayList<>();

    @AfterEach
    void close() {
        run.close();
    }

    static Stream<Integer> seeds() {
        return IntStream.range(0, SEEDS).boxed();
    }

    private Command event(Random random) {
        String sensor = sensor(random);
        Fault fault = FAULTS.get(random.nextInt(FAULTS.size()));
        List<IntFunction<Command>> kinds = List.of(
                kind -> new Command.SwitchSensor(sensor, random.nextBoolean()),
                kind -> new Command.InjectFault(sensor, fault),
                kind -> new Command.InjectFault(sensor, fault),
                kind -> new Command.ClearFault(sensor, fault),
                kind -> new Command.ClearFaults(sensor),
                kind -> new Command.InjectMotorFault(MotorSide.LEFT, WEAK),
                kind -> new Command.ClearMotorFault(MotorSide.LEFT, WEAK));
        int kind = random.nextInt(kinds.size());
        return kinds.get(kind).apply(kind);
    }

    /** Returns an event, or a change of settings that the timeline leaves alone. */
    private Command edit(Random random) {
        if (random.nextInt(3) > 0) {
            return event(random);
        }
        RobotSpec robot = SessionFrames.frame(run.workspace()).snapshot().robot();
        SensorSpec sensor = robot.sensors().get(random.nextBoolean() ? FRONT : LEFT);
        double value = (1 + random.nextInt(9)) / 10.0;
        List<Supplier<Command>> kinds = List.of(
                () -> new Command.ConfigureSensor(sensor.withRange(value)),
                () -> new Command.ConfigureSensor(sensor.withNoise(value / 100)),
                () -> new Command.SetPlatform(robot.length(), robot.width(), value),
                () -> new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT.withDistance(value)));
        return kinds.get(random.nextInt(kinds.size())).get();
    }

    private String sensor(Random random) {
        return sensorId(random.nextBoolean() ? FRONT : LEFT);
    }

    /** Returns the present id of a sensor, given its place in the list of the robot. */
    private String sensorId(int index) {
        return run.scenario().setup().robot().sensorIds().get(index);
    }

    private void plan(Random random) {
        List<TimedCommand> timeline = IntStream.range(0, 6)
                .mapToObj(i -> new TimedCommand((1 + random.nextInt(MAX_TICKS)) / 100.0, event(random)))
                .toList();
        runOnEdt(() -> run.controller().change(now -> now.withSetup(now.setup().withTimeline(timeline))));
        run.rest();
    }

    private void step(Random random, Function<Random, Command> command) {
        int kind = random.nextInt(23);
        if (kind < 6) {
            Command sent = command.apply(random);
            note(sent.toString());
            run.send(sent);
        } else if (kind == 6) {
            note("repair all");
            run.send(
                    new Command.ClearFaults(sensorId(FRONT)),
                    new Command.ClearFaults(sensorId(LEFT)),
                    new Command.ClearMotorFaults(MotorSide.LEFT));
        } else if (kind < 11) {
            note("undo " + callOnEdt(run.edits()::undoName));
            run.undo();
        } else if (kind < 13) {
            note("redo " + callOnEdt(run.edits()::redoName));
            run.redo();
        } else if (kind < 17) {
            int ticks = random.nextInt(21);
            note("advance by " + ticks);
            run.advance(ticks);
        } else if (kind < 19) {
            move(random);
        } else if (kind == 19) {
            note("restart");
            run.restart();
        } else if (kind == 20) {
            moveStart(random);
        } else {
            rename(random);
        }
    }

    private void rename(Random random) {
        String before = sensor(random);
        String after = NEW_IDS.get(random.nextInt(NEW_IDS.size()));
        note("rename " + before + " to " + after);
        runOnEdt(() -> sensors.rename(before, after));
        run.rest();
    }

    private void note(String step) {
        steps.add(step);
    }

    private void move(Random random) {
        long tick = random.nextInt((int) run.tick() + 20);
        boolean cancelled = random.nextInt(3) == 0;
        note((cancelled ? "cancel a move to " : "move to ") + tick);
        if (cancelled) {
            runOnEdt(() -> {
                run.controller().navigator().seek(tick);
                run.workspace().cancelTask();
            });
            run.rest();
        } else {
            run.seek(tick);
        }
    }

    private void moveStart(Random random) {
        SimulationSetup setup = run.scenario().setup();
        Pose start = setup.start();
        double by = (1 + random.nextInt(5)) / 100.0;
        note("move the start by " + by);
        runOnEdt(() -> editor.moveStart(setup, new Pose(start.x() + by, start.y(), start.heading())));
        run.rest();
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void theEditedScenarioLeadsToTheRunThatIsShown(int seed) {
        Random random = new Random(seed);
        plan(random);
        for (int i = 0; i < STEPS; i++) {
            step(random, this::event);
            if (run.tick() > 0) {
                assertEquals(
                        headlessHash(run.scenario(), run.tick()),
                        SessionFrames.trajectoryHash(run.workspace()),
                        "seed " + seed + ": " + steps);
            }
        }
    }

    private static long headlessHash(Scenario scenario, long ticks) {
        SimulationSetup setup = scenario.setup();
        return HeadlessRun.run(setup.withDuration(setup.timeOf(ticks)), ControllerMode.DIRECT, List.of())
                .trajectoryHash();
    }

    /** Faults may be in another order if the timeline has changed them in the meantime. */
    @ParameterizedTest
    @MethodSource("seeds")
    void withoutEditsTheTimelineAloneDecides(int seed) {
        Random random = new Random(seed);
        plan(random);
        SimulationSetup planned = run.scenario().setup();
        long last = MAX_TICKS;
        for (int i = 0; i < STEPS; i++) {
            step(random, this::edit);
            last = Math.max(last, run.tick());
        }
        undoAll();
        // An edit that was undone at a later tick is in effect until then, whenever the run is made again.
        run.advanceTo(Math.max(last, run.tick()) + 2);
        // The run has passed edits that are redone because they were ahead of it.
        undoAll();
        try (Session expected = Session.replay(new Journal(planned, List.of(), 0), run.tick(), tick -> true)) {
            assertEquals(
                    state(expected.frame()),
                    state(SessionFrames.frame(run.workspace())),
                    "seed " + seed + ": " + planned.timeline() + "\n" + steps);
        }
        assertEquals(planned.withTimeline(List.of()), run.scenario().setup().withTimeline(List.of()));
    }

    private void undoAll() {
        for (int i = 0; i < STEPS && callOnEdt(run.edits()::canUndo); i++) {
            note("undo " + callOnEdt(run.edits()::undoName));
            run.undo();
        }
    }

    private static List<Object> state(SessionFrame frame) {
        Snapshot snapshot = frame.snapshot();
        List<Object> state = new ArrayList<>(List.of(snapshot.robot(), frame.controller()));
        snapshot.sensors().forEach(sensor -> state.add(sorted(sensor.faults())));
        state.add(sorted(snapshot.motorFaults().left()));
        return state;
    }

    private static List<String> sorted(List<?> faults) {
        return faults.stream().map(Object::toString).sorted().toList();
    }
}
