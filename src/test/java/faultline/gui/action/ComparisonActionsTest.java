package faultline.gui.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.session.ReferenceRun;
import faultline.gui.document.RunComparison;
import faultline.gui.text.ContactText;
import faultline.scenario.Scenario;
import java.util.List;
import org.junit.jupiter.api.Test;

class ComparisonActionsTest {

    private static List<String> caption(ReferenceRun run) {
        return ComparisonActions.createOverlay(new RunComparison("other", run, null, false, false))
                .caption();
    }

    private static ReferenceRun replay(SimulationSetup setup, long ticks) {
        return ReferenceRun.replay(new Journal(setup, List.of(), ticks), tick -> true);
    }

    @Test
    void theCaptionSaysWhereTheGhostCollidedFirst() throws Exception {
        SimulationSetup office = Scenario.loadShipped("office.xml").setup();
        assertTrue(caption(replay(office, 500)).stream().noneMatch(line -> line.contains("Collision")));
        ReferenceRun collided = replay(office.withController(new ControllerSpec.Drive(6, 6)), 3000);
        String expected = ContactText.collision(collided.collision().orElseThrow());
        assertTrue(expected.startsWith("Collision with "), expected);
        assertEquals(1, caption(collided).stream().filter(expected::equals).count(), "" + caption(collided));
    }
}
