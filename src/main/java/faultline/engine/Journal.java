package faultline.engine;

import faultline.control.ControllerSpec;
import faultline.control.RecordedDecision;
import faultline.world.Command;
import java.util.List;

/**
 * The commands of a run from outside, in addition to its setup's timeline. With the setup they are enough to replay the
 * run to the bit.
 *
 * @param setup the setup of the run
 * @param entries the entries, in the order in which they were executed
 * @param ticks the number of ticks made
 * @param decisions those of a controller that is not part of the program; empty for others
 */
public record Journal(SimulationSetup setup, List<Entry> entries, long ticks, List<RecordedDecision> decisions) {

    /**
     * Creates a journal from copies of the lists.
     *
     * @param setup the setup of the run
     * @param entries the entries, in the order in which they were executed
     * @param ticks the number of ticks made
     * @param decisions those of a controller that is not part of the program; empty for others
     */
    public Journal {
        entries = List.copyOf(entries);
        decisions = List.copyOf(decisions);
    }

    /**
     * Creates the journal of a run with a controller that is part of the program.
     *
     * @param setup the setup of the run
     * @param entries the commands from outside, in order
     * @param ticks the number of ticks of the run
     */
    public Journal(SimulationSetup setup, List<Entry> entries, long ticks) {
        this(setup, entries, ticks, List.of());
    }

    /** {@return the setup with a controller that repeats the recorded decisions where the run's own may be missing} */
    public SimulationSetup replayableSetup() {
        return setup.controller() instanceof ControllerSpec.Foreign foreign
                ? setup.withController(
                        new ControllerSpec.Recorded(foreign.wantedDistance().orElseThrow(), ticks, decisions))
                : setup;
    }

    /**
     * {@return the timeline of the setup without the commands that were void} These were about an obstacle that an
     * entry had removed. They were refused, but not reported.
     */
    public List<SimulationSetup.TimedCommand> effectiveTimeline() {
        return VoidCommands.removedFrom(this);
    }

    /** {@return the journal of the run with a controller that repeats the recorded decisions, if it needs one} */
    public Journal withRecordedController() {
        return new Journal(replayableSetup(), entries, ticks, decisions);
    }

    /**
     * An executed command.
     *
     * @param tick the tick at whose start it was executed
     * @param command the command
     */
    public record Entry(long tick, Command command) {}
}
