package faultline.scenario;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import java.util.ArrayList;
import java.util.List;

/** Makes a plain scenario of what was done in a run, so that running it gives the same trajectory to the bit. */
public final class JournalScenario {

    private JournalScenario() {}

    /**
     * The scenario that replays a journal.
     *
     * @param base the scenario that the run was started from; gives the name and the description
     * @param journal what was done to the run
     * @return lasts as long as the run had; expects nothing, because another run was made than the one that the base
     *     speaks of
     */
    public static Scenario create(Scenario base, Journal journal) {
        SimulationSetup setup = journal.replayableSetup();
        List<TimedCommand> timeline = new ArrayList<>(setup.timeline());
        journal.entries().forEach(entry -> timeline.add(new TimedCommand(setup.timeOf(entry.tick()), entry.command())));
        SimulationSetup replay = setup.withTimeline(timeline).withDuration(setup.timeOf(journal.ticks()));
        return new Scenario(base.name(), base.description(), true, replay, Expectation.NONE);
    }
}
