package faultline.gui.document;

import faultline.engine.Journal;
import faultline.engine.session.Session;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/** Moves the run to other ticks: a new session replays the journal of the old one. Event dispatch thread only. */
public final class RunNavigator implements WorkspaceListener {

    private static final long NONE = -1;

    private final Workspace workspace;
    /** The furthest tick of the sessions before the open one. */
    private long furthestTick;

    private long replayEnd = NONE;

    RunNavigator(Workspace workspace) {
        this.workspace = workspace;
    }

    /**
     * Moves the run to the end of a tick, asynchronously, and pauses it there. Later commands are executed again at
     * their ticks, unless another command is executed before.
     *
     * @param tick the tick, not negative
     */
    public void seek(long tick) {
        workspace.openDocument().ifPresent(now -> {
            now.session().pause();
            CompletableFuture<Journal> journal = now.session().fullJournal();
            journal.thenAcceptAsync(past -> sessionLeft(now, past), EventQueue::invokeLater);
            WorkspaceTask task =
                    new WorkspaceTask(TaskKind.GO_TO, now.document().displayPath());
            workspace.start(
                    task,
                    () -> new OpenDocument(now.document(), Session.replay(journal.join(), tick, reached -> {
                        task.progress().setFraction((double) reached / tick);
                        return true;
                    })));
        });
    }

    private void sessionLeft(OpenDocument left, Journal journal) {
        if (workspace
                .openDocument()
                .filter(now -> now.document() == left.document())
                .isPresent()) {
            furthestTick = Math.max(furthestTick, journal.ticks());
        }
    }

    /** Moves the run back by one tick, asynchronously, and pauses it there; does nothing while a task is active. */
    public void stepBack() {
        if (workspace.task().isEmpty() && currentTick() > 0) {
            seek(currentTick() - 1);
        }
    }

    private long currentTick() {
        return workspace
                .openDocument()
                .map(now -> now.session().frame().snapshot().tick())
                .orElse(0L);
    }

    @Override
    public void scenarioOpened() {
        workspace.openDocument().map(now -> now.document().initial()).ifPresent(this::runStarted);
    }

    @Override
    public void scenarioRestarted() {
        scenarioOpened();
    }

    /** A recorded run has been further than it is at its start. */
    private void runStarted(Scenario scenario) {
        furthestTick = scenario.recorded() ? scenario.setup().ticks() : 0;
        replayEnd = scenario.recorded() ? furthestTick : NONE;
    }

    /** Forgets the later ticks, because a command has been executed. */
    void discardFuture() {
        furthestTick = 0;
        replayEnd = NONE;
    }

    /** Returns the last tick of a recorded run; empty if the run is not a replay, or has been changed by a command. */
    public OptionalLong replayEnd() {
        return replayEnd == NONE ? OptionalLong.empty() : OptionalLong.of(replayEnd);
    }

    /**
     * Returns the furthest tick of the run, however often it has been moved back. A command sets it to its own tick.
     */
    public long furthestTick() {
        return Math.max(furthestTick, currentTick());
    }
}
