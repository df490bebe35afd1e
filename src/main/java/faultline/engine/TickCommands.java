package faultline.engine;

import faultline.world.Command;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What is done to the world between two ticks: first what the timeline holds for the coming one, then what comes from
 * outside, which is journaled.
 */
final class TickCommands {

    private final SimulationSetup setup;
    private final World world;
    private final Timeline timeline;
    private final CommandListener listener;
    private final List<Journal.Entry> journal = new ArrayList<>();
    private boolean dueApplied;

    TickCommands(SimulationSetup setup, World world, CommandListener listener) {
        this.setup = setup;
        this.world = world;
        this.timeline = new Timeline(setup);
        this.listener = listener;
        executeDue(0);
    }

    /** Does what the timeline holds for the coming tick, unless that is done; it comes before anything from outside. */
    void applyDueCommands() {
        if (!dueApplied) {
            executeDue(world.tick() + 1);
            dueApplied = true;
        }
    }

    /** The tick is over. */
    void endTick() {
        dueApplied = false;
    }

    private void executeDue(long tick) {
        while (timeline.isDue(tick)) {
            executeAt(timeline.take(), tick);
        }
    }

    private Optional<String> executeAt(Command command, long tick) {
        Optional<String> refusal = world.execute(command);
        listener.commandHandled(tick, command, refusal);
        return refusal;
    }

    /** Does something from outside, and journals it unless it is refused; says why it was. */
    Optional<String> execute(Command command) {
        applyDueCommands();
        long tick = world.tick() + 1;
        Optional<String> refusal = executeAt(command, tick);
        if (refusal.isEmpty()) {
            journal.add(new Journal.Entry(tick, command));
        }
        return refusal;
    }

    /** What would take a command back that is not done yet. */
    List<Command> inverseOf(Command command) {
        applyDueCommands();
        return world.inverseOf(command);
    }

    Journal journal() {
        return new Journal(setup, journal, world.tick());
    }
}
