package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A run that is repeated from its journal, to be compared with another one. */
class ReferenceRunTest {

    @Test
    void theRobotOfEachTickHasTheSettingsOfThatTick() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0));
        Command.SetPlatform smaller = new Command.SetPlatform(0.2, 0.15, 0.25);
        Journal journal = new Journal(setup, List.of(new Journal.Entry(5, smaller)), 10);
        ReferenceRun run = ReferenceRun.replay(journal, tick -> true);
        assertEquals(setup.robot(), run.robot(0));
        assertEquals(setup.robot(), run.robot(4));
        assertEquals(smaller.appliedTo(setup.robot()), run.robot(5));
        assertEquals(smaller.appliedTo(setup.robot()), run.robot(11));
    }
}
