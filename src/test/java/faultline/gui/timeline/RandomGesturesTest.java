package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.GainRule;
import faultline.control.Threshold;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskFailures;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.StoppedClock;
import faultline.gui.edit.UndoController;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random drags and repeated changes, some of them quick, with undo, redo and restarts. All changes of a gesture are one
 * step: its undo restores the scenario before the first of them, its redo the one after the last. After moves of the
 * run, which can divide a gesture, the undo of all steps restores the first scenario, and their redo each one before an
 * undo. The system property {@code faultline.edits} sets the number of sequences.
 */
@ExtendWith(EdtChecker.class)
class RandomGesturesTest {

    private static final int SEEDS = Integer.getInteger("faultline.edits", 10);
    private static final int EDITS = 25;
    private static final String CHAIR = "chair-1";
    private static final String STAND = "coat-stand";
    /** Milliseconds. */
    private static final List<Integer> PAUSES = List.of(0, 500, 2000);

    private Workspace workspace;
    private RunController run;
    private CommandSender sender;
    private UndoController undo;
    private TimelineEditor timeline;
    private ScenarioEditor properties;
    private long now;

    private Random random;
    /** Whether the timeline changes an obstacle that is edited. */
    private boolean planned;
    /** Whether the run is moved. */
    private boolean moved;

    private final List<String> notes = new ArrayList<>();
    private final Deque<Step> done = new ArrayDeque<>();
    private final Deque<Step> undone = new ArrayDeque<>();
    /** What the last change was about, or the drag; null if the next change is another step in any case. */
    private Object last;

    private long lastTime;
    /** Stands for the drag, null for none. */
    private Object drag;

    /** Returns the commands of the next message of the drag. */
    private Supplier<List<Command>> dragging;

    private List<Command> restoring = List.of();
    /** The item that was changed last, as it is since. */
    private TimelineItem lastItem;

    private Object lastItemKey;
    /** Makes all values different. */
    private int number;

    @TempDir
    private Path folder;

    /** An expected step of undo. */
    private record Step(Scenario before, Scenario after) {}

    @BeforeEach
    void create() {
        runOnEdt(() -> {
            workspace = new Workspace();
            run = new RunController(workspace);
            sender = StoppedClock.sender(run::send, () -> now);
            undo = new UndoController(sender, () -> {});
            timeline = new TimelineEditor(workspace, run, undo, note -> {});
            properties = new ScenarioEditor(run, undo);
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
    void eachGestureIsAStepOfUndo(int seed) throws Exception {
        check(seed);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void allStepsOfAMovedRunAreUndoneAndRedone(int seed) throws Exception {
        moved = true;
        check(seed);
    }

    private void check(int seed) throws Exception {
        random = new Random(seed);
        planned = random.nextBoolean();
        Scenario first = first();
        notes.add("seed " + seed + ": " + first.setup().timeline());
        runOnEdt(() -> new DocumentStore(workspace).create(first));
        SessionFrames.awaitScenario(workspace);
        long latest = 0;
        for (int i = 0; i < EDITS; i++) {
            step();
            latest = Math.max(latest, tick());
            assertReloads();
        }
        endDrag();
        advance((int) (latest - tick()) + 2);
        List<Scenario> states = new ArrayList<>(List.of(scenario()));
        while (callOnEdt(undo::canUndo)) {
            undo();
            states.add(scenario());
        }
        assertEquals(0, done.size(), notes::toString);
        assertScenario(first);
        advance(2);
        assertShownObstacles();
        for (int i = states.size() - 2; i >= 0; i--) {
            redo();
            assertScenario(states.get(i));
        }
        if (!planned) {
            assertShownObstacles();
        }
    }

    /** The robot hardly moves. What the timeline changes is also dragged, or the timeline is edited. */
    private Scenario first() throws Exception {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        SimulationSetup setup = office.setup();
        RobotSpec robot = setup.robot();
        List<TimedCommand> timeline = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            timeline.addAll(item().commands());
        }
        for (int i = 0; planned && i < 2; i++) {
            timeline.add(new TimedCommand((5 + random.nextInt(60)) / 100.0, plannedCommand()));
        }
        return office.withSetup(setup.withRobot(robot.withPlatform(robot.length(), robot.width(), 0.01))
                        .withController(WallFollowing.DEFAULT)
                        .withTimeline(timeline))
                .withExpectation(Expectation.NONE);
    }

    private Command plannedCommand() {
        return random.nextInt(3) > 0
                ? new Command.MoveObstacle(CHAIR, pose())
                : new Command.PlaceObstacle(new Obstacle(CHAIR, circle(0.3), pose()));
    }

    private ObstacleShape circle(double radius) {
        return new ObstacleShape.CircleShape(radius + number() / 10000.0);
    }

    private Scenario scenario() {
        return callOnEdt(() -> workspace.scenario().orElseThrow());
    }

    private SessionFrame frame() {
        return SessionFrames.frame(workspace);
    }

    private long tick() {
        return SessionFrames.tick(workspace);
    }

    private void assertReloads() throws Exception {
        Scenario open = scenario();
        Path file = Files.write(folder.resolve("saved.xml"), open.toBytes());
        assertEquals(open, Scenario.load(file), notes::toString);
    }

    private void assertScenario(Scenario expected) {
        assertEquals(expected, scenario(), notes::toString);
    }

    private void assertShownObstacles() {
        Journal journal = new Journal(scenario().setup(), List.of(), 0);
        try (Session replayed = Session.replay(journal, tick(), tick -> true)) {
            assertEquals(
                    List.copyOf(replayed.frame().snapshot().obstacles()),
                    List.copyOf(frame().snapshot().obstacles()),
                    notes::toString);
        }
    }

    private void step() {
        now += PAUSES.get(random.nextInt(PAUSES.size()));
        switch (random.nextInt(20)) {
            case 0, 1 -> undo();
            case 2 -> redo();
            case 3 -> {
                if (moved) {
                    undoAndRedo();
                } else {
                    undoSeveral();
                }
            }
            case 4 -> restart();
            case 5, 6, 7 -> advance(random.nextInt(30));
            case 8 -> {
                if (moved) {
                    moveRun();
                }
            }
            case 9 -> {
                if (drag == null) {
                    beginDrag();
                } else if (random.nextInt(3) == 0) {
                    cancelDrag();
                } else {
                    endDrag();
                }
            }
            case 10, 11, 12 -> editScenario();
            default -> sendSome();
        }
    }

    /** Sends commands about the same thing, or those of the drag, some in quick succession. */
    private void sendSome() {
        int kind = random.nextInt(7);
        for (int i = random.nextInt(3); i >= 0; i--) {
            if (drag == null) {
                send(kind);
            } else {
                change(drag, () -> sender.send(dragging.get()));
            }
            now += random.nextInt(3) * 300;
        }
    }

    private void undo() {
        note("undo " + callOnEdt(undo::undoName));
        interrupt();
        runOnEdt(undo::undo);
        rest();
        undone();
    }

    private void undoSeveral() {
        int count = 2 + random.nextInt(2);
        note("undo " + count);
        interrupt();
        runOnEdt(() -> IntStream.range(0, count).forEach(i -> undo.undo()));
        rest();
        for (int i = 0; i < count - 1 && done.size() > 1; i++) {
            undone.push(done.pop());
        }
        undone();
    }

    /** Undoes an edit, of which the run may have executed only a part, and redoes it: the run is as it was. */
    private void undoAndRedo() {
        SimulationSetup setup = scenario().setup();
        long next = tick() + 1;
        // A run that is simulated again, because the setup changes, shows what the timeline does at the next tick.
        boolean comparable = setup.timeline().stream().noneMatch(timed -> setup.tickAt(timed.time()) == next);
        if (comparable && callOnEdt(undo::canUndo)) {
            List<Object> before = shown();
            undo();
            redo();
            assertEquals(before, shown(), notes::toString);
        }
    }

    private List<Object> shown() {
        return List.of(
                List.copyOf(frame().snapshot().obstacles()), frame().snapshot().robot(), frame().controller());
    }

    private void undone() {
        if (!moved && !done.isEmpty()) {
            Step step = done.pop();
            undone.push(step);
            assertScenario(step.before());
        }
    }

    private void redo() {
        note("redo " + callOnEdt(undo::redoName));
        runOnEdt(undo::redo);
        rest();
        if (!undone.isEmpty()) {
            Step step = undone.pop();
            done.push(step);
            assertScenario(step.after());
        }
    }

    /**
     * Not after the timeline has changed what is edited: the undo of edits of two runs that have changed equal poses is
     * not exact.
     */
    private void restart() {
        if (!planned) {
            note("restart");
            interrupt();
            runOnEdt(run::restart);
            rest();
        }
    }

    /** Moves the run back, or forward past edits that are ahead. */
    private void moveRun() {
        long tick = random.nextInt((int) tick() + 30);
        note("move to " + tick);
        runOnEdt(() -> run.navigator().seek(tick));
        rest();
        SessionFrames.awaitTick(workspace, tick);
    }

    private void advance(int ticks) {
        note("advance by " + ticks);
        long end = tick() + ticks;
        runOnEdt(() -> IntStream.range(0, ticks).forEach(i -> run.step()));
        SessionFrames.awaitTick(workspace, end);
        rest();
    }

    private void note(String what) {
        notes.add("\n" + now + " ms, tick " + tick() + ": " + what);
    }

    private void interrupt() {
        last = null;
        if (drag != null) {
            drag = new Object();
        }
    }

    private void beginDrag() {
        note("begin a drag");
        last = null;
        drag = new Object();
        switch (random.nextInt(3)) {
            case 0 -> {
                List<String> ids = random.nextBoolean() ? List.of(CHAIR, STAND) : List.of(CHAIR);
                dragging = () -> ids.stream().map(id -> move(id, pose())).toList();
                restoring =
                        ids.stream().map(id -> move(id, obstacle(id).pose())).toList();
            }
            case 1 -> {
                Obstacle chair = obstacle(CHAIR);
                boolean keys = random.nextBoolean();
                dragging = () -> List.of(
                        keys && random.nextInt(3) == 0
                                ? move(CHAIR, pose())
                                : new Command.PlaceObstacle(new Obstacle(CHAIR, circle(0.05), chair.pose())));
                // If a key has moved the obstacle, too, a cancelled drag is a step without effect.
                restoring = keys ? List.of() : List.of(new Command.PlaceObstacle(chair));
            }
            default -> {
                SensorSpec sensor = frame().snapshot().robot().sensors().get(random.nextInt(2));
                dragging = () -> List.of(new Command.ConfigureSensor(sensor.withRange(1 + number() / 1000.0)));
                restoring = List.of(new Command.ConfigureSensor(sensor));
            }
        }
        runOnEdt(sender::beginGesture);
    }

    private static Command move(String id, Pose to) {
        return new Command.MoveObstacle(id, to);
    }

    private Obstacle obstacle(String id) {
        return frame().snapshot().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private void endDrag() {
        if (drag != null) {
            note("end the drag");
            runOnEdt(sender::endGesture);
            last = null;
            drag = null;
        }
    }

    /** A drag that has not changed anything yet has nothing to restore. */
    private void cancelDrag() {
        if (drag.equals(last) && !restoring.isEmpty()) {
            note("cancel the drag");
            change(drag, () -> sender.send(restoring));
        }
        endDrag();
    }

    /** Makes a change that is expected to be the same step as the one before if both have equal keys. */
    private void change(Object key, Runnable action) {
        boolean merged = key.equals(last) && (key == drag || now - lastTime <= 1000) && !done.isEmpty();
        Scenario before = scenario();
        note((merged ? "again " : "") + key);
        runOnEdt(action);
        rest();
        Scenario after = scenario();
        Step step = new Step(merged ? done.pop().before() : before, after);
        boolean hasEffect = !after.equals(step.before());
        if (!moved && hasEffect) {
            done.push(step);
        }
        if (!moved && (hasEffect || merged)) {
            undone.clear();
        }
        // What has no effect is no step that a later change could belong to.
        last = hasEffect ? key : null;
        lastTime = now;
    }

    private void send(int kind) {
        RobotSpec robot = frame().snapshot().robot();
        switch (kind) {
            case 0 -> {
                SensorSpec sensor = robot.sensors().get(random.nextInt(2));
                send(sensor.id(), new Command.ConfigureSensor(sensor.withRange(1 + number() / 1000.0)));
            }
            case 1 ->
                send("platform", new Command.SetPlatform(robot.length(), robot.width(), 0.01 + number() / 100000.0));
            case 2 -> send("distance", follower().withDistance(0.2 + number() / 1000.0));
            case 5 -> send("gains", follower().withGainRule(new GainRule.Length(0.2 + number() / 1000.0)));
            case 6 -> {
                Threshold threshold = random.nextBoolean() ? Threshold.AHEAD_MARGIN : Threshold.LOST_MARGIN;
                send(
                        threshold,
                        follower().withThreshold(threshold, sometimes(threshold.defaultValue(), number() / 1000.0)));
            }
            case 3 -> {
                String id = random.nextBoolean() ? CHAIR : STAND;
                send("move " + id, move(id, pose()));
            }
            default -> {
                // A new size is never a repetition.
                send(
                        new Object(),
                        new Command.PlaceObstacle(new Obstacle(
                                CHAIR, circle(0.05), obstacle(CHAIR).pose())));
            }
        }
    }

    private WallFollowing follower() {
        return (WallFollowing) frame().controller();
    }

    private void send(Object key, WallFollowing controller) {
        send(key, new Command.ConfigureController(controller));
    }

    private void send(Object key, Command command) {
        change(key, () -> sender.send(command));
    }

    /** Returns a value that a change may restore, or a new one. */
    private double sometimes(double usual, double other) {
        return random.nextInt(3) == 0 ? usual : other;
    }

    private Pose pose() {
        return new Pose(3 + number() / 1000.0, 4.5, 0);
    }

    private int number() {
        number++;
        return number;
    }

    private void editScenario() {
        SimulationSetup setup = scenario().setup();
        switch (random.nextInt(planned ? 2 : 6)) {
            case 0 -> {
                long seed = (long) sometimes(1, number());
                editScenario("properties", open -> open.withSeed(seed), open -> open.withSeed(setup.seed()));
            }
            case 1 -> {
                double rate = sometimes(1, 1 + number() / 1000.0);
                editScenario(
                        "drive",
                        open -> withRate(open, rate),
                        open -> withRate(open, setup.robot().turnRate()));
            }
            case 2 -> {
                TimelineItem item = item();
                change(new Object(), () -> timeline.add(item, null));
            }
            default -> replaceItems();
        }
    }

    /** Changes the setup if the change has an effect, as the window does. */
    private void editScenario(
            String name, UnaryOperator<SimulationSetup> change, UnaryOperator<SimulationSetup> inverse) {
        SimulationSetup setup = scenario().setup();
        if (!change.apply(setup).equals(setup)) {
            change(
                    name,
                    () -> properties.edit(
                            "edit." + name,
                            open -> open.withSetup(change.apply(open.setup())),
                            open -> open.withSetup(inverse.apply(open.setup()))));
        }
    }

    private static SimulationSetup withRate(SimulationSetup open, double rate) {
        return open.withRobot(open.robot().withTurnRate(rate));
    }

    private TimelineItem item() {
        double start = (10 + number() % 150) / 100.0;
        return switch (random.nextInt(3)) {
            case 0 -> TimelineItem.from(new Command.MoveObstacle("chair-2", pose()), start);
            default ->
                new TimelineItem(
                        new Command.InjectFault(
                                random.nextBoolean() ? "left" : "right", new Fault.Stuck(number() / 1000.0)),
                        start,
                        start + 0.5);
        };
    }

    private void replaceItems() {
        for (int i = random.nextInt(4); i >= 0; i--) {
            List<TimelineItem> items = callOnEdt(() -> timeline.model().items());
            if (items.isEmpty()) {
                return;
            }
            int index = lastItem != null && random.nextBoolean() ? items.indexOf(lastItem) : -1;
            if (index < 0) {
                index = random.nextInt(items.size());
            }
            replace(items.get(index), index);
            now += random.nextInt(3) * 300;
        }
    }

    private void replace(TimelineItem item, int index) {
        if (lastItemKey == null || !item.equals(lastItem)) {
            lastItemKey = new Object();
        }
        double start = (10 + random.nextInt(150)) / 100.0;
        double length = (1 + random.nextInt(50)) / 100.0;
        TimelineItem changed =
                item.isInterval() ? item.withTimes(start, start + length) : item.withTimes(start, item.end());
        lastItem = changed;
        note(item + " to " + changed);
        change(lastItemKey, () -> timeline.replace(index, changed));
    }

    private void rest() {
        Await.until(
                "the end of the edit",
                () -> !workspace.awaitsCommands() && workspace.task().isEmpty());
        SessionFrame frame = frame();
        runOnEdt(() -> {
            sender.pendingEdits().setRobot(frame.snapshot().robot());
            sender.pendingEdits().setController(frame.controller());
            undo.runAdvanced(frame.snapshot().tick());
        });
    }
}
