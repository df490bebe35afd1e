package faultline.engine.session;

import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Replays the journal of an earlier run, command by command. */
final class JournalPlayer {

    private final Deque<Journal.Entry> pending;
    private long endTick;

    JournalPlayer(Journal journal) {
        pending = new ArrayDeque<>(journal.entries());
        endTick = journal.ticks();
    }

    /** Advances a simulation by one tick, with the journal's commands for that tick. */
    void tick(Simulation simulation) {
        executeCommands(simulation);
        simulation.tick();
    }

    /** Executes the journal's commands for the next tick. */
    void executeCommands(Simulation simulation) {
        while (!pending.isEmpty() && pending.peek().tick() <= simulation.ticks() + 1) {
            execute(simulation, pending.remove().command());
        }
    }

    /**
     * Executes a command from outside. Settings of a sensor leave its switch as it is after the timeline's commands for
     * the tick. In a replay with the same setup, that is how the earlier run left it; the timeline of another setup may
     * switch the sensor at other times.
     */
    static CommandResult execute(Simulation simulation, Command command) {
        simulation.executeDueCommands();
        return simulation.execute(command.keepingSwitch(simulation.robot()));
    }

    /** Discards the rest of the journal, because the run now differs from it. */
    void discardPending() {
        pending.clear();
        endTick = 0;
    }

    /** Returns the simulation's journal, followed by the commands still to be replayed. */
    Journal fullJournal(Simulation simulation) {
        Journal done = simulation.journal();
        List<Journal.Entry> all = new ArrayList<>(done.entries());
        all.addAll(pending);
        return new Journal(done.setup(), all, Math.max(endTick, done.ticks()), done.decisions());
    }
}
