package faultline.gui.document;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.HashTrace;
import faultline.engine.session.Session;
import java.awt.EventQueue;
import java.util.Collections;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.LongConsumer;
import java.util.function.LongPredicate;
import java.util.function.ToLongFunction;
import java.util.function.UnaryOperator;

/** Moves the run to other ticks: a new session replays the journal of the old one. Event dispatch thread only. */
public final class RunNavigator implements WorkspaceListener {

    private static final ControllerSpec NO_CONTROLLER = new ControllerSpec.None();

    private final Workspace workspace;
    /**
     * Held during a replay, so that only one is in progress: a cancelled one ends after the tick that it simulates,
     * which can take seconds and much memory in a large world.
     */
    private final Object replaying = new Object();

    private final RunExtent extent = new RunExtent();
    private ChangeState change = ChangeState.INCLUDED;
    /** Whether changes at tick 0 are part of the setup, while the run has them as commands of its first tick. */
    private boolean lacksStart;

    /** Whether the run has the last change of its setup. */
    private enum ChangeState {
        /** It has. */
        INCLUDED,
        /** No run with the change has started yet. */
        AWAITED,
        /** No run with the change has started yet; it resumes, or the present one if there will be none. */
        AWAITED_TO_RESUME
    }

    RunNavigator(Workspace workspace) {
        this.workspace = workspace;
    }

    /**
     * Moves the run to the end of a tick, not negative, asynchronously, and pauses it there, in the state in which it
     * was there before: with the commands that were executed before the next tick. Later commands are executed again at
     * their ticks, unless another command is executed before. If there are later events, all events are put on the
     * timeline before, where they act from their ticks on. From tick 0 the run moves with the edited setup, as by
     * {@link #beginWithChanges}. Does nothing while a scenario is being opened.
     *
     * <p>The tick is one of the present run. If the edited scenario has ticks of another length, because a restart was
     * cancelled, the run moves to its first tick that is not before that time.
     */
    public void seek(long tick) {
        workspace.openDocument().ifPresent(now -> seek(now, tick, now.tickOfScenario(tick)));
    }

    /** Moves the run to the first tick that is not before a time, seconds, as {@link #seek} does. */
    public void seekTime(double seconds) {
        workspace.openDocument().ifPresent(now -> {
            long target = now.document().initial().setup().tickAt(seconds);
            seek(now, now.session().setup().tickAt(seconds), target);
        });
    }

    /** Moves the run to a tick of the edited scenario, given the tick of the run that is shown until it is there. */
    private void seek(OpenDocument now, long shown, long target) {
        if (isOpening()) {
            return;
        }
        if (change == ChangeState.AWAITED_TO_RESUME) {
            change = ChangeState.AWAITED;
        }
        workspace.fire(listener -> listener.seekStarted(shown));
        LongConsumer preparation = ticks -> {
            if (ticks == 0 && target > 0) {
                includeChangesAtStart(now);
            }
            now.document().prepareMoveTo(target);
        };
        simulate(now, new RunMove(TaskKind.GO_TO, preparation, past -> target, Session::replay), () -> {});
    }

    /**
     * Begins the run with the edited setup, asynchronously, if it is paused at tick 0 and its setup may have been
     * changed there: these changes act from the start on, as they will when the scenario is saved. Otherwise they would
     * act in the first tick. {@code then} is called when it has begun, and not if that is cancelled or fails. Returns
     * false, without an effect, if there is nothing to do, and while a scenario is being opened.
     */
    boolean beginWithChanges(OpenDocument now, Runnable then) {
        boolean paused = !now.session().status().running();
        boolean changed = lacksStart || now.document().mayChangeSetupAtStart();
        if (currentTick() > 0 || !paused || isOpening() || !changed) {
            return false;
        }
        LongConsumer preparation = ticks -> {
            if (ticks == 0) {
                includeChangesAtStart(now);
            }
        };
        simulate(now, new RunMove(TaskKind.RESIMULATE, preparation, Journal::ticks, Session::resimulate), then);
        return true;
    }

    /** Makes the changes of the setup at tick 0 part of the setup, and the events there part of its timeline. */
    private void includeChangesAtStart(OpenDocument now) {
        if (now.document().changesSetupAtStart()) {
            SimulationSetup before = now.document().initial().setup();
            now.document().changeForRestart(UnaryOperator.identity());
            if (workspace.isOpen(now.document())) {
                awaitChange();
                lacksStart = true;
                workspace.fire(listener -> listener.editsIncluded(before));
                workspace.fire(WorkspaceListener::titleChanged);
            }
        }
    }

    /** Returns the time of the run, seconds. */
    public double currentTime() {
        return workspace
                .openDocument()
                .map(now -> now.session().frame().snapshot().time())
                .orElse(0.0);
    }

    boolean isOpening() {
        return workspace.task().filter(active -> active.kind() == TaskKind.OPEN).isPresent();
    }

    /** Notes that the run lacks a change of the setup if the restart or the move that includes it does not succeed. */
    void awaitChange() {
        if (change == ChangeState.INCLUDED) {
            change = ChangeState.AWAITED;
        }
    }

    /**
     * Simulates the run with its edited setup up to the present tick, asynchronously; a running one then resumes. While
     * a scenario is being opened, the run stays as it is, and lacks the change if that is cancelled or fails.
     */
    void resimulate() {
        workspace.openDocument().ifPresent(now -> {
            awaitChange();
            if (isOpening()) {
                return;
            }
            if (now.session().status().running()) {
                change = ChangeState.AWAITED_TO_RESUME;
            }
            discardFuture();
            LongConsumer preparation = ticks -> now.document().prepareResimulation();
            ToLongFunction<Journal> present = past -> now.tickOfScenario(past.ticks());
            simulate(now, new RunMove(TaskKind.RESIMULATE, preparation, present, Session::resimulate), () -> {});
        });
    }

    /** Starts a session after a simulation. */
    @FunctionalInterface
    private interface SessionStarter {
        Session start(Journal journal, long tick, LongPredicate shouldContinue);
    }

    /**
     * A simulation of the run from its start.
     *
     * @param preparation edits the document before its journal is taken, given the present tick; all results are known
     * @param end the tick to simulate to, given the journal of the run until now
     */
    private record RunMove(
            TaskKind kind, LongConsumer preparation, ToLongFunction<Journal> end, SessionStarter starter) {}

    /** Pauses a run, simulates it asynchronously, and calls {@code then} when the new session has replaced the old. */
    private void simulate(OpenDocument now, RunMove move, Runnable then) {
        now.session().pause();
        CompletableFuture<Journal> pastOfRun = now.session().journal();
        CompletableFuture<Journal> whole = now.session()
                .fullJournal()
                .thenApplyAsync(
                        journal -> {
                            move.preparation().accept(journal.ticks());
                            return now.document().journal(journal.ticks());
                        },
                        EventQueue::invokeLater);
        CompletableFuture<Journal> past = whole.thenCombineAsync(
                pastOfRun,
                (made, ofRun) -> {
                    leave(now, ofRun.ticks());
                    return now.document().renames().inJournal(ofRun);
                },
                EventQueue::invokeLater);
        WorkspaceTask task = new WorkspaceTask(move.kind(), now.document().displayPath());
        Callable<OpenDocument> maker = () -> {
            Journal journal = whole.join();
            long tick = move.end().applyAsLong(past.join());
            synchronized (replaying) {
                task.progress().throwIfCancelled();
                LongPredicate shouldContinue = reached -> {
                    task.progress().setFraction((double) reached / tick);
                    return true;
                };
                return now.withSession(workspace, choice -> {
                    SimulationSetup setup = choice.apply(journal.setup());
                    return move.starter()
                            .start(new Journal(setup, journal.entries(), journal.ticks()), tick, shouldContinue);
                });
            }
        };
        workspace.start(task, maker, () -> {
            reportOtherDecisions(now, past.join(), whole.join());
            then.run();
        });
    }

    /** Reports a run that differs from the one before although only its controller can have decided differently. */
    private void reportOtherDecisions(OpenDocument before, Journal past, Journal whole) {
        if (past.setup().controller() instanceof ControllerSpec.Foreign
                && past.setup()
                        .withController(NO_CONTROLLER)
                        .equals(whole.setup().withController(NO_CONTROLLER))
                && Collections.indexOfSubList(whole.entries(), past.entries()) == 0) {
            OptionalLong tick = hashes(workspace.openDocument().orElseThrow()).firstDifference(hashes(before), 0);
            tick.ifPresent(first -> workspace.fire(
                    listener -> listener.decidedDifferently(past.setup().timeOf(first))));
        }
    }

    private static HashTrace hashes(OpenDocument document) {
        return document.session().frame().recording().hashTrace();
    }

    /** Notes the tick of a session that is left. Its journal may have more, also those of another setup. */
    private void leave(OpenDocument left, long tick) {
        if (workspace.isOpen(left.document())) {
            extent.leave(left.session().setup(), tick);
        }
    }

    @Override
    public void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline) {
        lacksStart = false;
        endResimulationAndResume();
    }

    @Override
    public void taskFinished() {
        if (change != ChangeState.INCLUDED) {
            endResimulationAndResume();
            workspace.fire(WorkspaceListener::setupChangeDeferred);
        }
    }

    private void endResimulationAndResume() {
        boolean resume = change == ChangeState.AWAITED_TO_RESUME;
        change = ChangeState.INCLUDED;
        if (resume) {
            workspace.openDocument().ifPresent(now -> now.session().resume());
        }
    }

    /** Moves the run back by one tick, asynchronously, and pauses it there; does nothing while a task is active. */
    public void stepBack() {
        if (currentTick() > 0 && workspace.task().isEmpty()) {
            // A longer tick of the edited scenario may contain both this tick and the one before.
            workspace
                    .openDocument()
                    .ifPresent(now -> seek(now, currentTick() - 1, now.tickOfScenario(currentTick()) - 1));
        }
    }

    /** Moves the run to a tick as {@link #seek} does, and returns true; does nothing while a task is active. */
    public boolean seekIfIdle(long tick) {
        boolean idle = workspace.task().isEmpty();
        if (idle) {
            seek(tick);
        }
        return idle;
    }

    /** Returns the tick of the run, 0 if there is none. */
    public long currentTick() {
        return workspace
                .openDocument()
                .map(now -> now.session().frame().snapshot().tick())
                .orElse(0L);
    }

    @Override
    public void scenarioOpened() {
        lacksStart = false;
        change = ChangeState.INCLUDED;
        workspace.openDocument().map(now -> now.document().initial()).ifPresent(extent::start);
    }

    @Override
    public void scenarioRestarted(SimulationSetup before) {
        scenarioOpened();
    }

    /** Forgets the later ticks, because a command has been executed or the setup has been changed. */
    void discardFuture() {
        extent.discardFuture();
    }

    /** Returns the last tick of a recorded run; empty if the run is not a replay, or has been changed by a command. */
    public OptionalLong replayEnd() {
        return extent.replayEnd();
    }

    /**
     * Returns the furthest tick of the run, however often it has been moved back. A command sets it to its own tick,
     * and a change of the setup to the present one.
     */
    public long furthestTick() {
        long before = workspace
                .openDocument()
                .map(now -> extent.furthestTickIn(now.session().setup()))
                .orElse(0L);
        return Math.max(before, currentTick());
    }
}
