package faultline.engine;

import faultline.world.Command;
import java.util.List;

/**
 * What was done to one run from outside, beyond its setup's timeline: with the setup, enough to replay it to the bit.
 *
 * @param setup the run's
 * @param entries in the order in which they were applied
 * @param ticks how far the run had come
 */
public record Journal(SimulationSetup setup, List<Entry> entries, long ticks) {

    public Journal {
        entries = List.copyOf(entries);
    }

    /**
     * One command that was applied.
     *
     * @param tick the tick at whose start it was
     * @param command what was done
     */
    public record Entry(long tick, Command command) {}
}
