package faultline.engine;

import faultline.control.ControllerSpec;
import faultline.control.RecordedDecision;
import faultline.world.Command;
import java.util.List;

/**
 * What was done to one run from outside, beyond its setup's timeline: with the setup, enough to replay it to the bit.
 *
 * @param setup the run's
 * @param entries in the order in which they were applied
 * @param ticks how far the run had come
 * @param decisions those of a controller that is not part of the program; empty for others
 */
public record Journal(SimulationSetup setup, List<Entry> entries, long ticks, List<RecordedDecision> decisions) {

    public Journal {
        entries = List.copyOf(entries);
        decisions = List.copyOf(decisions);
    }

    /** The journal of a run with a controller that is part of the program. */
    public Journal(SimulationSetup setup, List<Entry> entries, long ticks) {
        this(setup, entries, ticks, List.of());
    }

    /** Returns the setup with a controller that repeats the recorded decisions where the run's own may be missing. */
    public SimulationSetup replayableSetup() {
        return setup.controller() instanceof ControllerSpec.Foreign foreign
                ? setup.withController(
                        new ControllerSpec.Recorded(foreign.wantedDistance().orElseThrow(), ticks, decisions))
                : setup;
    }

    /**
     * One command that was applied.
     *
     * @param tick the tick at whose start it was
     * @param command what was done
     */
    public record Entry(long tick, Command command) {}
}
