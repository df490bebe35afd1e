package faultline.engine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** What a run has still before it of the journal of an earlier one. */
final class Replay {

    private final Deque<Journal.Entry> pending;
    private long end;

    Replay(Journal journal) {
        pending = new ArrayDeque<>(journal.entries());
        end = journal.ticks();
    }

    /** Makes a tick, with what the journal has for it. */
    void tick(Simulation simulation) {
        while (!pending.isEmpty() && pending.peek().tick() <= simulation.ticks() + 1) {
            simulation.apply(pending.remove().command());
        }
        simulation.tick();
    }

    /** From now on something else happens than the journal has. */
    void drop() {
        pending.clear();
        end = 0;
    }

    /** What was done, and what is still to come. */
    Journal whole(Simulation simulation) {
        Journal done = simulation.journal();
        List<Journal.Entry> all = new ArrayList<>(done.entries());
        all.addAll(pending);
        return new Journal(done.setup(), all, Math.max(end, done.ticks()));
    }
}
