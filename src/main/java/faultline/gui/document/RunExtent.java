package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import java.util.OptionalLong;

/** How far the run of a document has been in the sessions before the open one. */
final class RunExtent {

    private static final long NONE = -1;

    private long furthestTick;
    /** The length of the ticks up to {@link #furthestTick}, seconds. */
    private double dt;

    private long replayEnd = NONE;

    /** Notes the start of the run of a scenario; all of a recorded run can be reached from there. */
    void start(Scenario scenario) {
        furthestTick = scenario.recorded() ? scenario.setup().ticks() : 0;
        dt = scenario.setup().dt();
        replayEnd = scenario.recorded() ? furthestTick : NONE;
    }

    /** Notes the tick of a session that is left, which may have a setup with ticks of another length. */
    void leave(SimulationSetup setup, long tick) {
        furthestTick = Math.max(furthestTickIn(setup), tick);
        dt = setup.dt();
    }

    /** Forgets the later ticks, because a command has been executed or the setup has been changed. */
    void discardFuture() {
        furthestTick = 0;
        replayEnd = NONE;
    }

    /** Returns the furthest tick in the ticks of a run, which may have another length. */
    long furthestTickIn(SimulationSetup run) {
        return run.dt() == dt ? furthestTick : run.tickAt(furthestTick * dt);
    }

    /** Returns the last tick of a recorded run; empty if the run is not a replay, or has been changed by a command. */
    OptionalLong replayEnd() {
        return replayEnd == NONE ? OptionalLong.empty() : OptionalLong.of(replayEnd);
    }
}
