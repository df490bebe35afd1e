package faultline.scenario;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import java.util.ArrayList;
import java.util.List;

/** Makes a scenario of the commands of a run, so that running it gives the same trajectory to the bit. */
public final class JournalScenario {

    private JournalScenario() {}

    /**
     * {@return the scenario that replays a journal} It lasts as long as the run did, and expects nothing, because the
     * run may differ from the one that the base expects. It lacks the commands that were void, because they would be
     * refused as mistakes of its timeline.
     *
     * @param base the scenario of the run; gives the name and the description
     * @param journal the commands of the run
     */
    public static Scenario create(Scenario base, Journal journal) {
        SimulationSetup setup = journal.replayableSetup();
        List<TimedCommand> timeline = new ArrayList<>(journal.effectiveTimeline());
        journal.entries().forEach(entry -> timeline.add(new TimedCommand(setup.timeOf(entry.tick()), entry.command())));
        SimulationSetup replay = setup.withTimeline(timeline).withDuration(setup.timeOf(journal.ticks()));
        return new Scenario(base.name(), base.description(), true, replay, Expectation.NONE);
    }
}
