package faultline.engine.session;

import faultline.engine.Journal;
import faultline.engine.Simulation;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** What a run has still before it of the journal of an earlier one. */
final class JournalPlayer {

    private final Deque<Journal.Entry> pending;
    private long endTick;

    JournalPlayer(Journal journal) {
        pending = new ArrayDeque<>(journal.entries());
        endTick = journal.ticks();
    }

    /** Makes a tick, with what the journal has for it. */
    void tick(Simulation simulation) {
        while (!pending.isEmpty() && pending.peek().tick() <= simulation.ticks() + 1) {
            simulation.execute(pending.remove().command());
        }
        simulation.tick();
    }

    /** From now on something else happens than the journal has. */
    void discardPending() {
        pending.clear();
        endTick = 0;
    }

    /** What was done, and what is still to come. */
    Journal fullJournal(Simulation simulation) {
        Journal done = simulation.journal();
        List<Journal.Entry> all = new ArrayList<>(done.entries());
        all.addAll(pending);
        return new Journal(done.setup(), all, Math.max(endTick, done.ticks()));
    }
}
