package faultline.gui.document;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.session.Session;
import faultline.scenario.Scenario;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/**
 * Takes the run on the bench to another moment of its own: a new session that replays the old one's journal up to
 * there.
 */
public final class RunNavigator {

    private final Workspace workspace;
    private long furthestTick;
    private OptionalLong replayEnd = OptionalLong.empty();

    RunNavigator(Workspace bench) {
        this.workspace = bench;
    }

    /**
     * Goes to another moment of the run, soon, and holds there. What was done later is done again when its tick comes,
     * unless something else is done before.
     *
     * @param tick not negative
     */
    public void seek(long tick) {
        workspace.openDocument().ifPresent(now -> {
            now.session().pause();
            CompletableFuture<Journal> journal = now.session().fullJournal();
            workspace.startTask(
                    TaskKind.GO_TO,
                    now.document().displayPath(),
                    way -> new OpenDocument(now.document(), Session.replay(journal.join(), tick, reached -> {
                        way.setFraction((double) reached / tick);
                        return way.isActive();
                    })));
        });
    }

    /** Goes back by one tick, soon, and holds there; while it is on its way, nothing. */
    public void stepBack() {
        if (workspace.taskProgress().isEmpty()) {
            workspace
                    .openDocument()
                    .map(now -> now.session().frame().snapshot().tick())
                    .filter(tick -> tick > 0)
                    .ifPresent(tick -> seek(tick - 1));
        }
    }

    /** A session has begun, by a task: a saved run has been farther than it is now. */
    void sessionStarted(TaskKind task, Scenario scenario) {
        if (task != TaskKind.GO_TO) {
            furthestTick = scenario.recorded() ? scenario.setup().ticks() : 0;
            replayEnd = scenario.recorded() ? OptionalLong.of(furthestTick) : OptionalLong.empty();
        }
    }

    /** The run has come here. */
    void frameReached(Frame frame) {
        furthestTick = Math.max(furthestTick, frame.snapshot().tick());
    }

    /** Something else is done now than was done before: what came later is no more. */
    void discardFuture() {
        furthestTick = 0;
        replayEnd = OptionalLong.empty();
    }

    /**
     * Where the replay of a saved run ends.
     *
     * @return a tick; empty where the run is no replay, or none any more because something was done to it
     */
    public OptionalLong replayEnd() {
        return replayEnd;
    }

    /**
     * How far the run has been, whatever moment it was taken back to since; what is done to it there gives it another
     * future.
     *
     * @return ticks
     */
    public long furthestTick() {
        return furthestTick;
    }
}
