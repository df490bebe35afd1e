package faultline.engine;

import faultline.world.Command;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** A setup's timed commands in the order of their ticks, handed out once each. */
final class Timeline {

    private record Due(long tick, Command command) {
    }

    private final List<Due> dues = new ArrayList<>();
    private int next;

    Timeline(Setup setup) {
        setup.timeline().forEach(timed -> dues.add(new Due(setup.tickAt(timed.at()), timed.command())));
        // Stable: within a tick the file's order stays.
        dues.sort(Comparator.comparingLong(Due::tick));
    }

    /** Whether a command is due at a tick or before, and not yet handed out. */
    boolean isDue(long tick) {
        return next < dues.size() && dues.get(next).tick() <= tick;
    }

    Command take() {
        return dues.get(next++).command();
    }
}
