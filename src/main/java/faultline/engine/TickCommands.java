package faultline.engine;

import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;

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
            executeNow(timeline.take());
        }
    }

    private CommandResult executeNow(Command command) {
        CommandResult result = world.execute(command);
        listener.commandHandled(result);
        return result;
    }

    /** Executes a command from outside, and adds it to the journal unless it is refused. */
    CommandResult execute(Command command) {
        applyDueCommands();
        CommandResult result = executeNow(command);
        if (result.refusal().isEmpty()) {
            journal.add(new Journal.Entry(result.tick(), command));
        }
        return result;
    }

    Journal journal() {
        return new Journal(setup, journal, world.tick());
    }
}
