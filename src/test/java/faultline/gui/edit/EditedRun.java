package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.session.Session;
import faultline.gui.Await;
import faultline.gui.change.TimelineEvents;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskFailures;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * A run, paused, that is edited, moved and restarted without a window. Each call waits until it has taken effect. The
 * clock of the edits stands still.
 */
public final class EditedRun {

    private final Workspace workspace = callOnEdt(Workspace::new);
    private RunController controller;
    private DocumentStore documents;
    private CommandSender sender;
    private UndoController edits;
    private ScenarioEditor editor;
    private ObstacleEditor obstacles;
    private SensorEditor sensors;
    private Optional<String> shownUndo = Optional.empty();

    /** Opens the office. A task that fails ends the test. */
    public EditedRun() {
        this(Path.of("scenarios/office.xml"), new TaskFailures());
    }

    /** Opens a file with a listener, which takes the failures of tasks. */
    public EditedRun(Path file, WorkspaceListener listener) {
        runOnEdt(() -> {
            controller = new RunController(workspace);
            documents = new DocumentStore(workspace);
            sender = StoppedClock.sender(controller::send);
            edits = new UndoController(sender, () -> shownUndo = edits.undoName());
            edits.follow(workspace, controller);
            editor = new ScenarioEditor(controller, edits);
            obstacles = new ObstacleEditor(workspace, editor);
            sensors = new SensorEditor(workspace, editor, note -> {});
            sender.setNaming(workspace::ofViews);
            workspace.addListener(listener);
            documents.open(file);
        });
        SessionFrames.awaitScenario(workspace);
    }

    public void close() {
        runOnEdt(workspace::close);
    }

    public Workspace workspace() {
        return workspace;
    }

    public RunController controller() {
        return controller;
    }

    public DocumentStore documents() {
        return documents;
    }

    ObstacleEditor obstacles() {
        return obstacles;
    }

    SensorEditor sensors() {
        return sensors;
    }

    public CommandSender sender() {
        return sender;
    }

    public UndoController edits() {
        return edits;
    }

    /** Returns the name of the edit that is undone next, as it was when the edits were said to have changed. */
    Optional<String> shownUndo() {
        return callOnEdt(() -> shownUndo);
    }

    public Scenario scenario() {
        return callOnEdt(() -> workspace.scenario().orElseThrow());
    }

    List<TimedCommand> timeline() {
        return scenario().setup().timeline();
    }

    /** Replaces the timeline of the scenario. */
    public void plan(List<TimedCommand> timeline) {
        runOnEdt(() -> controller.change(now -> now.withSetup(now.setup().withTimeline(timeline))));
        rest();
    }

    /** Adds commands to the timeline of the scenario, with undo. */
    void planWithUndo(TimedCommand... commands) {
        List<TimedCommand> planned = List.of(commands);
        runOnEdt(() -> editor.edit(
                "edit.properties",
                now -> TimelineEvents.with(now, planned),
                now -> TimelineEvents.without(now, planned)));
        rest();
    }

    /** Returns the obstacle of an id in the run. */
    Optional<Obstacle> shown(String id) {
        return find(SessionFrames.frame(workspace).snapshot().obstacles(), id);
    }

    /** Returns the obstacle of an id at the start of the scenario. */
    Optional<Obstacle> atStart(String id) {
        return find(scenario().setup().world().obstacles(), id);
    }

    private static Optional<Obstacle> find(Collection<Obstacle> obstacles, String id) {
        return obstacles.stream().filter(obstacle -> obstacle.id().equals(id)).findFirst();
    }

    /** Checks that a run of the edited scenario has the same obstacles at the present tick. */
    void assertSameObstacles() {
        try (Session replayed = Session.replay(new Journal(scenario().setup(), List.of(), 0), tick(), tick -> true)) {
            assertEquals(
                    List.copyOf(replayed.frame().snapshot().obstacles()),
                    SessionFrames.frame(workspace).snapshot().obstacles());
        }
    }

    public long tick() {
        return SessionFrames.tick(workspace);
    }

    void advance(int ticks) {
        long end = tick() + ticks;
        for (int i = 0; i < ticks; i++) {
            runOnEdt(controller::step);
        }
        SessionFrames.awaitTick(workspace, end);
        runOnEdt(() -> edits.runAdvanced(end));
    }

    public void advanceTo(long tick) {
        advance(Math.toIntExact(tick - tick()));
    }

    public void send(Command... commands) {
        runOnEdt(() -> {
            edits.endEdit();
            sender.send(List.of(commands));
        });
        rest();
    }

    /** Sends a command of the drag that has begun. */
    void drag(Command command) {
        runOnEdt(() -> sender.send(command));
        rest();
    }

    void removeSensor(String id) {
        runOnEdt(() -> sensors.remove(id, restored -> {}));
        rest();
    }

    /** Gives a sensor of the scenario another id, which is not refused. */
    void renameSensor(String id, String newId) {
        assertEquals(Optional.empty(), callOnEdt(() -> sensors.rename(id, newId)));
        rest();
    }

    /** Gives an obstacle of the scenario another id; returns why it is refused, empty if it is not. */
    Optional<String> rename(String id, String newId) {
        Optional<String> refusal = callOnEdt(() -> obstacles.rename(id, newId));
        rest();
        return refusal;
    }

    public void undo() {
        runOnEdt(edits::undo);
        rest();
    }

    public void redo() {
        runOnEdt(edits::redo);
        rest();
    }

    public void restart() {
        runOnEdt(controller::restart);
        rest();
    }

    public void seek(long tick) {
        runOnEdt(() -> controller.navigator().seek(tick));
        rest();
        SessionFrames.awaitTick(workspace, tick);
    }

    /** Waits for the end of the last edit, and takes the ids of the run as the window does. */
    public void rest() {
        Await.until(
                "the end of the edit",
                () -> !workspace.awaitsCommands() && workspace.task().isEmpty());
        runOnEdt(workspace::takeRenames);
    }
}
