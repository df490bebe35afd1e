package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.engine.session.SessionView;
import faultline.gui.change.ObstacleOrigins;
import faultline.gui.change.SensorReference;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/**
 * Holds the open scenario and its run. Opening a file, restarting the run and moving it to another tick start a new
 * session; the old one is closed when the new one has started. {@link DocumentStore} loads and saves scenarios,
 * {@link RunController} controls the run. Event dispatch thread only.
 */
public final class Workspace implements AutoCloseable {

    /** The time for which the end of a run may keep the program from exiting, milliseconds. */
    private static final long MAX_END_MILLIS = 10_000;

    private final List<WorkspaceListener> listeners = new ArrayList<>();
    private OpenDocument open;
    private volatile BiFunction<SimulationSetup, String, SimulationSetup> controllerChoice = (setup, name) -> setup;
    /** Whether a session has started since a controller was chosen. */
    private volatile boolean choiceTried;

    private WorkspaceTask task;
    /** Restarts the failed task, unless another one has started since then. */
    private Runnable failedTask = () -> {};

    private boolean closed;
    /** Completes when the edits that wait for the end of a restart or a move have been sent; null if none wait. */
    private CompletableFuture<Void> deferredEdits;

    /** Adds a listener; listeners are called in the order in which they were added. */
    public void addListener(WorkspaceListener listener) {
        listeners.add(listener);
    }

    void fire(Consumer<WorkspaceListener> event) {
        listeners.forEach(event);
    }

    /** Returns the open document; empty before the first session. */
    Optional<OpenDocument> openDocument() {
        assert EventQueue.isDispatchThread();
        return Optional.ofNullable(open);
    }

    /** Returns the frames and the status of the run; empty before the first session. */
    public Optional<SessionView> session() {
        return openDocument().map(OpenDocument::session);
    }

    private Optional<ScenarioDocument> document() {
        return openDocument().map(OpenDocument::document);
    }

    /** Returns whether a document is the open one. */
    boolean isOpen(ScenarioDocument other) {
        return document().filter(now -> now == other).isPresent();
    }

    /** Returns the active task; empty if there is none. */
    public Optional<WorkspaceTask> task() {
        assert EventQueue.isDispatchThread();
        return Optional.ofNullable(task);
    }

    /**
     * Sets the function that replaces the scenario's controller in the next session and all later ones. The scenario
     * itself does not change. Saved runs that are opened after the next session keep their own controller. Returns what
     * sets the function before it again.
     */
    public Runnable setControllerChoice(BiFunction<SimulationSetup, String, SimulationSetup> choice) {
        BiFunction<SimulationSetup, String, SimulationSetup> before = controllerChoice;
        boolean tried = choiceTried;
        controllerChoice = choice;
        choiceTried = false;
        return () -> {
            controllerChoice = before;
            choiceTried = tried;
        };
    }

    /** Returns whether the open scenario is a saved run that keeps its own controller. */
    public boolean keepsController() {
        return openDocument().filter(OpenDocument::ownController).isPresent();
    }

    /** Returns whether a session has started since a controller was chosen. Any thread may call it. */
    boolean isChoiceTried() {
        return choiceTried;
    }

    /**
     * Returns the setup of a named scenario with the chosen controller. Any thread but the event dispatch thread may
     * call it.
     */
    SimulationSetup withChosenController(SimulationSetup setup, String scenarioName) {
        return controllerChoice.apply(setup, scenarioName);
    }

    /** Starts a task that makes a document to replace the open one. It cancels the active task. */
    void start(WorkspaceTask newTask, Callable<OpenDocument> maker) {
        start(newTask, maker, () -> {});
    }

    /** Starts a task as {@link #start(WorkspaceTask, Callable)}; {@code then} runs after its document is open. */
    void start(WorkspaceTask newTask, Callable<OpenDocument> maker, Runnable then) {
        start(newTask, maker, then, () -> {});
    }

    /**
     * Starts a task as {@link #start(WorkspaceTask, Callable, Runnable)}; {@code otherwise} runs after the task has
     * failed or was cancelled. If a failed task is started again, one of both runs again. After {@link #close}, no task
     * starts.
     */
    void start(WorkspaceTask newTask, Callable<OpenDocument> maker, Runnable then, Runnable otherwise) {
        if (closed) {
            return;
        }
        if (newTask.kind() == TaskKind.OPEN) {
            sendDeferredEdits();
        }
        cancelActiveTask();
        task = newTask;
        failedTask = () -> {};
        BackgroundTasks.compute(
                () -> newTask.progress().perform(maker),
                made -> {
                    boolean opened = taskDone(newTask, made);
                    (opened ? then : otherwise).run();
                },
                failure -> {
                    taskFailed(newTask, failure, () -> start(newTask, maker, then, otherwise));
                    otherwise.run();
                });
    }

    /** Restarts the last task if it has failed. */
    public void retry() {
        failedTask.run();
    }

    /** Cancels the active task without other effects. */
    public void cancelTask() {
        cancelActiveTask();
        finishTask();
    }

    /** Returns whether the run is being restarted or moved to another tick. */
    boolean isRepositioning() {
        return task().filter(active -> active.kind() != TaskKind.OPEN).isPresent();
    }

    /** Cancels a restart or a move that edits wait for, so that the run gets them before the scenario is left. */
    private void sendDeferredEdits() {
        while (deferredEdits != null && isRepositioning()) {
            // An undo that has waited may start another one.
            cancelTask();
        }
    }

    private void cancelActiveTask() {
        task().ifPresent(active -> active.progress().cancel());
        task = null;
    }

    private void finishTask() {
        task = null;
        fire(WorkspaceListener::taskFinished);
    }

    private void taskFailed(WorkspaceTask ended, Throwable failure, Runnable again) {
        if (ended.progress().isActive()) {
            failedTask = again;
            finishTask();
            fire(listener -> listener.taskFailed(ended.kind(), ended.name(), failure));
        }
    }

    /** Opens the document of a task, and returns false if the task has been cancelled. */
    private boolean taskDone(WorkspaceTask ended, OpenDocument made) {
        if (!ended.progress().isActive()) {
            made.session().close();
            return false;
        }
        if (ended.kind() == TaskKind.RESTART) {
            // A save to another file may have ended in the meantime or may still be active.
            document().ifPresent(made.document()::continueFrom);
        }
        OpenDocument before = open;
        closeSession();
        open = made;
        choiceTried = true;
        fireStarted(ended.kind(), before);
        fire(WorkspaceListener::sessionStarted);
        fire(WorkspaceListener::titleChanged);
        finishTask();
        return true;
    }

    private void fireStarted(TaskKind kind, OpenDocument before) {
        if (kind == TaskKind.OPEN) {
            fire(WorkspaceListener::scenarioOpened);
        } else if (kind == TaskKind.RESTART) {
            SimulationSetup setup = before.document().initial().setup();
            fire(listener -> listener.scenarioRestarted(setup));
        } else {
            long tick = open.session().frame().snapshot().tick();
            boolean eventsOnTimeline = open.document().runRepositioned(tick);
            SimulationSetup setup = open.document().initial().setup();
            fire(listener -> listener.runRepositioned(tick, setup, eventsOnTimeline));
        }
    }

    /** Sets what another program has written to the file; null if it cannot be read. */
    void setSavedScenario(Scenario found) {
        document().ifPresent(document -> document.setSaved(found));
        fire(WorkspaceListener::titleChanged);
    }

    /** Lets a save replace what the file holds without another question. */
    void allowReplacement() {
        document().ifPresent(ScenarioDocument::allowReplacement);
    }

    /** Returns the file of the scenario; empty if it has none. */
    public Optional<Path> file() {
        return document().flatMap(ScenarioDocument::file);
    }

    /** Returns the scenario with all edits; empty before the first session. */
    public Optional<Scenario> scenario() {
        return document().map(ScenarioDocument::edited);
    }

    /** Returns the ids of the scenario's obstacles, at the start and on its timeline. */
    public Set<String> obstacleIds() {
        return scenario().map(now -> ObstacleOrigins.idsIn(now.setup())).orElse(Set.of());
    }

    /**
     * Returns what a sensor is called in a list of the ids of a robot, given an id that it has, had before or will have
     * there; the id itself if the list lacks the sensor.
     */
    public String presentId(String id, List<String> ids) {
        return document().map(now -> now.renames().presentId(id, ids)).orElse(id);
    }

    /**
     * Returns what gives a sensor of the scenario with this id the one that it has after the changes of ids to come.
     */
    public Supplier<String> followSensor(String id) {
        return document().map(now -> now.renames().followSensor(id)).orElse(() -> id);
    }

    /** Returns an earlier command of the timeline with the id that its sensor or obstacle has now, if it is there. */
    public Command presentCommand(Command command) {
        return document().map(now -> now.presentCommand(command)).orElse(command);
    }

    /** Returns a command of the views with the id that its obstacle has in the edited scenario. */
    public Command ofViews(Command command) {
        return document().map(now -> now.renames().ofViews(command)).orElse(command);
    }

    /** Returns the id that an obstacle of the views has in the edited scenario. */
    public String ofViews(String id) {
        return document().map(now -> now.renames().ofViews(id)).orElse(id);
    }

    /**
     * Returns what gives the obstacles of the views the ids that they have in the run; must be called before a frame is
     * shown. Empty if they have them already.
     */
    public Optional<UnaryOperator<String>> takeRenames() {
        return document().flatMap(now -> now.renames().takeForViews());
    }

    /** Returns whether the scenario has the sensor or the obstacle that a command is about. */
    public boolean hasSubjectOf(Command command) {
        return scenario().filter(now -> hasSubject(now.setup(), command)).isPresent();
    }

    private static boolean hasSubject(SimulationSetup setup, Command command) {
        boolean places = command instanceof Command.PlaceObstacle;
        Optional<String> obstacle = places ? Optional.empty() : ObstacleOrigins.subject(command);
        return obstacle.map(ObstacleOrigins.idsIn(setup)::contains).orElse(true)
                && SensorReference.isOn(setup.robot(), command);
    }

    /** Returns the scenario that the file holds, as far as is known; empty if there is none. */
    public Optional<Scenario> savedScenario() {
        return document().flatMap(ScenarioDocument::saved);
    }

    /** Returns what a save of the scenario may replace without a question; empty for nothing. */
    public Optional<Scenario> replaceableScenario() {
        return document().flatMap(ScenarioDocument::replaceable);
    }

    /** Returns whether the scenario differs from its file, or will because edits wait for the run. */
    public boolean isChanged() {
        return deferredEdits != null
                || document().filter(ScenarioDocument::isChanged).isPresent();
    }

    /** Returns whether there are commands whose results are not known yet, because the run is busy. */
    public boolean awaitsCommands() {
        return deferredEdits != null
                || !hasRunDied()
                        && document().filter(ScenarioDocument::awaitsCommands).isPresent();
    }

    /** Notes that an edit waits until the run has been restarted or moved. */
    void editDeferred() {
        if (deferredEdits == null) {
            deferredEdits = new CompletableFuture<>();
            fire(WorkspaceListener::titleChanged);
        }
    }

    /** Notes that the edits that waited have been sent to the run, or dropped. */
    void deferredEditsSent() {
        CompletableFuture<Void> sent = deferredEdits;
        if (sent != null) {
            deferredEdits = null;
            sent.complete(null);
            // The answers show what has changed.
            edited().ifPresent(edited -> edited.thenRun(() -> fire(WorkspaceListener::titleChanged)));
        }
    }

    /**
     * Returns the scenario with all edits that have been requested, those included that wait until the run has been
     * restarted or moved; empty before the first session. The future completes on the event dispatch thread, also if
     * another scenario has been opened by then.
     */
    Optional<CompletableFuture<Scenario>> edited() {
        return openDocument().map(this::edited);
    }

    private CompletableFuture<Scenario> edited(OpenDocument requested) {
        if (deferredEdits != null) {
            return deferredEdits.thenCompose(sent -> edited(requested));
        }
        OpenDocument now = openDocument()
                .filter(open -> open.document().continues(requested.document()))
                .orElse(requested);
        return now.edited()
                .thenCompose(edited -> deferredEdits == null ? CompletableFuture.completedFuture(edited) : edited(now));
    }

    /** Returns whether the thread of the run has died of an error; what has been edited is known nevertheless. */
    boolean hasRunDied() {
        return openDocument().filter(now -> now.session().hasEnded()).isPresent();
    }

    /**
     * Returns a scenario that replays the run so far exactly; empty before the first session. The future completes on a
     * background thread, exceptionally if the session is closed before.
     */
    public Optional<CompletableFuture<Scenario>> replayScenario() {
        return openDocument().map(now -> now.session()
                .journal()
                .thenApplyAsync(journal -> JournalScenario.create(now.document().initial(), journal)));
    }

    /** Ends the run and cancels the active task. The program does not exit before a controller had its time to end. */
    @Override
    public void close() {
        fire(WorkspaceListener::workspaceClosing);
        sendDeferredEdits();
        closed = true;
        cancelActiveTask();
        failedTask = () -> {};
        openDocument().map(OpenDocument::session).ifPresent(Workspace::awaitEndBeforeExit);
        closeSession();
    }

    private static void awaitEndBeforeExit(Session session) {
        BackgroundTasks.performBeforeExit(() -> session.awaitEnd(MAX_END_MILLIS), () -> {}, failure -> {});
    }

    private void closeSession() {
        openDocument().map(OpenDocument::session).ifPresent(Session::close);
        open = null;
    }
}
