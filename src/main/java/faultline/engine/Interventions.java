package faultline.engine;

import faultline.world.Command;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What is done to the world between two ticks: first what the timeline holds for the coming one, then what comes from outside, which is
 * journaled.
 */
final class Interventions {

    private final Setup setup;
    private final World world;
    private final Timeline timeline;
    private final CommandListener listener;
    private final List<Journal.Entry> journal = new ArrayList<>();
    private boolean opened;

    Interventions(Setup setup, World world, CommandListener listener) {
        this.setup = setup;
        this.world = world;
        this.timeline = new Timeline(setup);
        this.listener = listener;
        applyDue(0);
    }

    /** Does what the timeline holds for the coming tick, unless that is done; it comes before anything from outside. */
    void open() {
        if (!opened) {
            applyDue(world.tick() + 1);
            opened = true;
        }
    }

    /** The tick is over. */
    void close() {
        opened = false;
    }

    private void applyDue(long tick) {
        while (timeline.isDue(tick)) {
            carryOut(timeline.take(), tick);
        }
    }

    private Optional<String> carryOut(Command command, long tick) {
        Optional<String> refusal = world.apply(command);
        listener.commanded(tick, command, refusal);
        return refusal;
    }

    /** Does something from outside, and journals it unless it is refused; says why it was. */
    Optional<String> apply(Command command) {
        open();
        long tick = world.tick() + 1;
        Optional<String> refusal = carryOut(command, tick);
        if (refusal.isEmpty()) {
            journal.add(new Journal.Entry(tick, command));
        }
        return refusal;
    }

    /** What would take a command back that is not done yet. */
    List<Command> undoing(Command command) {
        open();
        return world.undoing(command);
    }

    Journal journal() {
        return new Journal(setup, journal, world.tick());
    }
}
