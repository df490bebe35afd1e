package faultline.gui.document;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Session;
import faultline.scenario.Scenario;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/** Takes the run on the bench to another moment of its own: a new session that replays the old one's journal up to there. */
public final class TimeTravel {

    private final Bench bench;
    private long furthest;
    private OptionalLong replayEnd = OptionalLong.empty();

    TimeTravel(Bench bench) {
        this.bench = bench;
    }

    /**
     * Goes to another moment of the run, soon, and holds there. What was done later is done again when its tick comes, unless something
     * else is done before.
     *
     * @param tick not negative
     */
    public void goTo(long tick) {
        bench.work().ifPresent(now -> {
            now.session().pause();
            CompletableFuture<Journal> journal = now.session().wholeJournal();
            bench.begin(Task.GO_TO, now.document().name(), way -> new Work(now.document(), Session.replay(journal.join(), tick, reached -> {
                way.reached((double) reached / tick);
                return way.isWanted();
            })));
        });
    }

    /** Goes back by one tick, soon, and holds there; while it is on its way, nothing. */
    public void stepBack() {
        if (bench.underWay().isEmpty()) {
            bench.work().map(now -> now.session().frame().world().tick()).filter(tick -> tick > 0).ifPresent(tick -> goTo(tick - 1));
        }
    }

    /** A session has begun, by a task: a saved run has been farther than it is now. */
    void began(Task task, Scenario scenario) {
        if (task != Task.GO_TO) {
            furthest = scenario.recorded() ? scenario.setup().ticks() : 0;
            replayEnd = scenario.recorded() ? OptionalLong.of(furthest) : OptionalLong.empty();
        }
    }

    /** The run has come here. */
    void see(Frame frame) {
        furthest = Math.max(furthest, frame.world().tick());
    }

    /** Something else is done now than was done before: what came later is no more. */
    void turnOff() {
        furthest = 0;
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
     * How far the run has been, whatever moment it was taken back to since; what is done to it there gives it another future.
     *
     * @return ticks
     */
    public long furthest() {
        return furthest;
    }
}
