package faultline.engine;

import faultline.world.Command;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** A setup's timed commands in the order of their ticks; each is taken once. */
final class Timeline {

    private record DueCommand(long tick, Command command) {}

    private final List<DueCommand> commands = new ArrayList<>();
    private int next;

    Timeline(SimulationSetup setup) {
        setup.timeline().forEach(timed -> commands.add(new DueCommand(setup.tickAt(timed.time()), timed.command())));
        // The sort is stable: within a tick the order of the file is preserved.
        commands.sort(Comparator.comparingLong(DueCommand::tick));
    }

    /** Returns whether a command that has not been taken is due at a tick. */
    boolean isDue(long tick) {
        return next < commands.size() && commands.get(next).tick() <= tick;
    }

    Command take() {
        return commands.get(next++).command();
    }
}
