package faultline.engine;

import faultline.world.Command;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** A setup's timed commands in the order of their ticks; each is taken once. */
final class Timeline {

    private record Entry(long tick, Command command) {}

    private final List<Entry> entries = new ArrayList<>();
    private int next;

    Timeline(SimulationSetup setup) {
        setup.timeline().forEach(timed -> entries.add(new Entry(setup.tickAt(timed.time()), timed.command())));
        // Stable: within a tick the file's order stays.
        entries.sort(Comparator.comparingLong(Entry::tick));
    }

    /** Returns whether a command that has not been taken is due at a tick. */
    boolean isDue(long tick) {
        return next < entries.size() && entries.get(next).tick() <= tick;
    }

    Command take() {
        return entries.get(next++).command();
    }
}
