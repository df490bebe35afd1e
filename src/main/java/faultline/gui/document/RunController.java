package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.gui.change.LaterChange;
import faultline.gui.change.Rename;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/** Controls the run of the workspace. Event dispatch thread only. */
public final class RunController implements WorkspaceListener {

    private final Workspace workspace;
    private final RunNavigator navigator;
    private final EditSender edits;
    private final List<DeferredRequest> deferredRequests = new ArrayList<>();
    /** The number of changes that are made when the run has answered the commands before them. */
    private int pendingChanges;

    private double speed = 1;

    /** What waits until the run has been restarted or moved, and whether it is an edit. */
    private record DeferredRequest(Consumer<OpenDocument> action, boolean edit) {}

    /** Creates the controller of a workspace's run. */
    public RunController(Workspace workspace) {
        this.workspace = workspace;
        navigator = new RunNavigator(workspace);
        edits = new EditSender(workspace, navigator);
        workspace.addListener(navigator);
        workspace.addListener(this);
    }

    @Override
    public void scenarioOpened() {
        // The requests were sent to the previous scenario.
        deferredRequests.clear();
        reportDeferredEdits();
    }

    @Override
    public void sessionStarted() {
        workspace.openDocument().ifPresent(now -> {
            now.session().setSpeed(speed);
            pauseAtEnd(now);
        });
    }

    /** Pauses the run at the scenario's duration, where its verdict is shown; the user may resume it there. */
    private static void pauseAtEnd(OpenDocument open) {
        open.session().pauseAt(open.document().edited().setup().ticks());
    }

    @Override
    public void taskFinished() {
        List<DeferredRequest> requests = List.copyOf(deferredRequests);
        deferredRequests.clear();
        requests.forEach(this::submit);
        reportDeferredEdits();
    }

    /**
     * Sends a request to the session. While the run is restarted or moved to another tick, requests wait for the new
     * session: the old one ends, and its changes with it.
     */
    private void submit(DeferredRequest request) {
        if (isRepositioning()) {
            deferredRequests.add(request);
            reportDeferredEdits();
        } else {
            workspace.openDocument().ifPresent(request.action());
        }
    }

    private void submit(Consumer<OpenDocument> action) {
        submit(new DeferredRequest(action, false));
    }

    /** Tells the workspace whether edits wait. They are unsaved changes, and a save waits for them. */
    private void reportDeferredEdits() {
        if (pendingChanges > 0 || deferredRequests.stream().anyMatch(DeferredRequest::edit)) {
            workspace.editDeferred();
        } else {
            workspace.deferredEditsSent();
        }
    }

    /** Makes an edit of the open scenario, as soon as the run is no longer being restarted or moved. */
    public void runAfterRepositioning(Runnable edit) {
        submit(new DeferredRequest(open -> edit.run(), true));
    }

    /** Returns whether the run is being restarted or moved to another tick. */
    public boolean isRepositioning() {
        return workspace.isRepositioning();
    }

    /** Returns the navigator, which moves the run to other ticks. */
    public RunNavigator navigator() {
        return navigator;
    }

    /** Restarts the run with the edited scenario, asynchronously. */
    public void restart() {
        workspace.openDocument().ifPresent(now -> restart(now, now.edited(), () -> {}));
    }

    /** Restarts the run as {@link #restart} does, unless a scenario is being opened, which a restart would cancel. */
    public void restartUnlessOpening() {
        if (!navigator.isOpening()) {
            restart();
        }
    }

    /**
     * Moves the robot's start in the edited scenario and restarts the run, asynchronously. {@code move} is called once,
     * as soon as the run has answered all commands, with the start by then.
     */
    public void moveStart(UnaryOperator<Pose> move) {
        restartWith(scenario -> {
            SimulationSetup setup = scenario.setup();
            return scenario.withSetup(setup.withStart(move.apply(setup.start())));
        });
    }

    /**
     * Restarts the run with a change of the edited scenario, which is made as soon as the run has answered all commands
     * and is kept whatever becomes of the restart.
     */
    private void restartWith(UnaryOperator<Scenario> change) {
        workspace.openDocument().ifPresent(now -> {
            pendingChanges++;
            reportDeferredEdits();
            CompletableFuture<Scenario> changed = now.edited().thenApply(edited -> changeForRestart(now, change));
            restart(now, changed, () -> reportDeferredChange(now));
        });
    }

    private Scenario changeForRestart(OpenDocument open, UnaryOperator<Scenario> change) {
        pendingChanges--;
        SimulationSetup before = open.document().initial().setup();
        open.document().changeForRestart(change);
        if (workspace.isOpen(open.document())) {
            workspace.fire(listener -> listener.editsIncluded(before));
            workspace.fire(WorkspaceListener::titleChanged);
        }
        reportDeferredEdits();
        return open.document().edited();
    }

    /** Reports a change that the run lacks, unless another session has it. */
    private void reportDeferredChange(OpenDocument open) {
        if (workspace.task().isEmpty()
                && workspace.openDocument().filter(open::equals).isPresent()) {
            workspace.fire(WorkspaceListener::setupChangeDeferred);
        }
    }

    /** Restarts a run with a scenario, given what to do if that is cancelled or fails. */
    private void restart(OpenDocument open, CompletableFuture<Scenario> scenario, Runnable otherwise) {
        open.session().stopWaiting();
        workspace.start(
                new WorkspaceTask(TaskKind.RESTART, open.document().displayPath()),
                // The workspace sets the file when the session has started.
                () -> open.restartedAs(new ScenarioDocument(null, null, scenario.join()), workspace),
                () -> {},
                otherwise);
    }

    /**
     * Changes the edited scenario. If that changes its setup, the run is simulated again up to the present tick,
     * asynchronously, with the commands that it was sent; if it was running, it resumes. If it changes the length of a
     * tick, the run restarts.
     */
    public void change(UnaryOperator<Scenario> change) {
        workspace.openDocument().ifPresent(now -> {
            Scenario open = now.document().edited();
            SimulationSetup before = open.setup();
            if (change.apply(open).setup().dt() != before.dt()) {
                restartWith(change);
                return;
            }
            now.document().change(change);
            workspace.fire(WorkspaceListener::titleChanged);
            if (!now.document().edited().setup().equals(before)) {
                navigator.resimulate();
            }
        });
    }

    /** Makes all events of the run commands of the timeline. The edited scenario remains the same. */
    public void putEventsOnTimeline() {
        workspace.openDocument().ifPresent(now -> {
            now.document().putEventsOnTimeline();
            workspace.fire(listener ->
                    listener.eventsPutOnTimeline(now.document().initial().setup()));
        });
    }

    /**
     * Redoes or undoes changes of an earlier run in the setup at the start, as soon as the run has answered all
     * commands, and calls {@code onChanged}. The run is then simulated again as by {@link #change}, without the
     * commands that it was sent, except for events.
     *
     * @param changes what redoes or undoes the changes, in order, as if executed at their ticks, with its inverse
     */
    public void changeStart(List<CommandResult> changes, boolean redone, Runnable onChanged) {
        workspace.openDocument().ifPresent(open -> {
            pendingChanges++;
            reportDeferredEdits();
            Supplier<List<CommandResult>> present = open.document().renames().follow(changes);
            open.session()
                    .journal()
                    .whenComplete((journal, ended) ->
                            EventQueue.invokeLater(() -> changeStart(open, present.get(), redone, onChanged)));
        });
    }

    private void changeStart(OpenDocument open, List<CommandResult> changes, boolean redone, Runnable onChanged) {
        pendingChanges--;
        try {
            open.document().changeStart(changes, redone);
            if (workspace.isOpen(open.document())) {
                onChanged.run();
                workspace.fire(WorkspaceListener::titleChanged);
                if (isRepositioning()) {
                    // A restart or a move that has been requested since includes the change.
                    navigator.awaitChange();
                } else {
                    navigator.resimulate();
                }
            }
        } finally {
            // A save must not wait for a change that has failed.
            reportDeferredEdits();
        }
    }

    /** Returns whether two changes would make the same of the edited scenario. */
    public boolean haveSameEffect(UnaryOperator<Scenario> change, UnaryOperator<Scenario> other) {
        return workspace
                .scenario()
                .filter(now -> change.apply(now).equals(other.apply(now)))
                .isPresent();
    }

    /**
     * Changes the id of a sensor or an obstacle in the edited scenario and in the commands that the run was sent. The
     * run is simulated again up to the present tick as by {@link #change}. A command that has the earlier id gets the
     * new one.
     */
    public void rename(Rename rename) {
        workspace.openDocument().ifPresent(now -> {
            now.document().rename(rename);
            workspace.fire(WorkspaceListener::titleChanged);
            navigator.resimulate();
        });
    }

    /**
     * Sends commands, which are executed in order at the start of the same tick. {@code onExecuted} receives their
     * results on the event dispatch thread, none if the run has died; it is not called without a run. Commands may name
     * sensors by earlier ids or by those of the edited scenario, which the results have, and obstacles by the latter.
     */
    public void send(List<Command> commands, Consumer<List<CommandResult>> onExecuted) {
        int renames = workspace
                .openDocument()
                .map(open -> open.document().renames().changesOfObstacles())
                .orElse(0);
        submit(new DeferredRequest(open -> edits.send(open, commands, renames, onExecuted), true));
    }

    /**
     * Undoes or redoes an edit after the timeline has changed the same things. {@code onExecuted} is called as by
     * {@link #send(List, Consumer)} with a result for each change: that of the run, or that of the scenario if the run
     * stays as it is. Later commands of the run remain in this case.
     */
    public void changeLater(List<LaterChange> changes, Consumer<List<CommandResult>> onExecuted) {
        submit(new DeferredRequest(open -> edits.changeLater(open, changes, onExecuted), true));
    }

    /**
     * Returns the commands of the run's timeline that are executed after a tick and before a command that is sent now.
     */
    public List<Command> plannedSince(long tick) {
        return workspace
                .openDocument()
                .map(open -> open.document()
                        .named(PlannedCommands.between(open.session().setup(), tick + 1, navigator.currentTick() + 1)))
                .orElse(List.of());
    }

    /**
     * Returns the result of an event that the run has executed, with what undoes it after the timeline has been
     * changed; the result of another command itself.
     */
    public CommandResult presentResult(CommandResult event) {
        return workspace
                .openDocument()
                .map(open -> open.document().presentResult(event))
                .orElse(event);
    }

    /**
     * Notes that the executed commands of an undo, given by their results, undo events that the run has executed. If
     * these have no effect any more after a change of the timeline, the commands have none either.
     */
    public void noteUndo(List<CommandResult> undone, List<CommandResult> results) {
        workspace.openDocument().ifPresent(open -> open.document().noteUndo(undone, results));
    }

    /**
     * Drops the events later than a tick that change nothing any more, because a new edit at the tick has dropped the
     * redo that could give them an effect again. The edited scenario remains the same.
     */
    public void dropEventsWithoutEffectAfter(long tick) {
        workspace.openDocument().ifPresent(open -> open.document().dropEventsWithoutEffectAfter(tick));
    }

    /** Returns the time of a tick of the run, seconds; 0 without a run. */
    public double timeOf(long tick) {
        return workspace
                .openDocument()
                .map(open -> open.session().setup().timeOf(tick))
                .orElse(0.0);
    }

    /** Resumes or pauses the run. */
    public void toggleRunning() {
        submitUnlessFailed(session -> session.toggleRunning(session.status().running()));
    }

    /** Makes one tick and pauses. */
    public void step() {
        submitUnlessFailed(Session::step);
    }

    /**
     * Sends a request unless the run has failed. A run whose setup was changed at its start begins with the changes
     * before, also if it has failed there; if that is cancelled or fails, the request is dropped.
     */
    private void submitUnlessFailed(Consumer<Session> request) {
        submit(open -> {
            // The setup may be changed again while the run begins.
            if (!navigator.beginWithChanges(open, () -> submitUnlessFailed(request))) {
                requestUnlessFailed(open, request);
            }
        });
    }

    private void requestUnlessFailed(OpenDocument open, Consumer<Session> request) {
        if (open.session().status().failure().isPresent()) {
            workspace.fire(WorkspaceListener::failedRunResumed);
        } else {
            if (open.session().status().running()) {
                workspace.fire(WorkspaceListener::pauseRequested);
            }
            request.accept(open.session());
        }
    }

    /**
     * Sets the speed of this run and of all later ones, times real time, positive; positive infinity for unlimited
     * speed.
     */
    public void setSpeed(double factor) {
        speed = factor;
        workspace.openDocument().ifPresent(open -> open.session().setSpeed(factor));
    }
}
