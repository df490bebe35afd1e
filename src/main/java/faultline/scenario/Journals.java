package faultline.scenario;

import faultline.engine.Journal;
import faultline.engine.Setup;
import faultline.engine.Setup.Timed;
import java.util.ArrayList;
import java.util.List;

/** Makes a plain scenario of what was done in a run, so that running it gives the same trajectory to the bit. */
public final class Journals {

    private Journals() {
    }

    /**
     * The scenario that replays a journal.
     *
     * @param base the scenario that the run was started from; gives the name and the description
     * @param journal what was done to the run
     * @return lasts as long as the run had; expects nothing, because another run was made than the one that the base speaks of
     */
    public static Scenario toScenario(Scenario base, Journal journal) {
        Setup setup = journal.setup();
        List<Timed> timeline = new ArrayList<>(setup.timeline());
        journal.entries().forEach(entry -> timeline.add(new Timed(entry.tick() * setup.dt(), entry.command())));
        Setup replay = new Setup(setup.world(), setup.robot(), setup.start(), setup.controller(), timeline, setup.dt(), setup.seed(),
                journal.ticks() * setup.dt());
        return new Scenario(base.name(), base.description(), true, replay, Expectation.NONE);
    }
}
