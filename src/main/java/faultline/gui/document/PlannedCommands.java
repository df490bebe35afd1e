package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import java.util.Comparator;
import java.util.List;

/** Finds commands of the timeline of a setup by their ticks. */
final class PlannedCommands {

    private PlannedCommands() {}

    /** Returns the commands from one tick to another, both included, in the order of their execution. */
    static List<Command> between(SimulationSetup setup, long from, long to) {
        return setup.timeline().stream()
                .filter(planned -> isBetween(setup.tickAt(planned.time()), from, to))
                .sorted(Comparator.comparingLong(planned -> setup.tickAt(planned.time())))
                .map(TimedCommand::command)
                .toList();
    }

    private static boolean isBetween(long tick, long from, long to) {
        return from <= tick && tick <= to;
    }
}
