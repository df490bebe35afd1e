package faultline.gui.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.session.ReferenceRun;
import faultline.gui.document.RunComparison;
import faultline.gui.text.ContactText;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.util.List;
import org.junit.jupiter.api.Test;

class ComparisonActionsTest {

    private static final ControllerSource STANDING = new ControllerSource() {
        @Override
        public Controller start(RunConditions run) {
            return observation -> new Decision(0, 0, Telemetry.ofState(FollowerState.SEARCH));
        }

        @Override
        public boolean limitsAnswerTime() {
            return true;
        }
    };

    private static List<String> caption(ReferenceRun run) {
        return ComparisonActions.createOverlay(new RunComparison("other", run, null, false, false))
                .caption();
    }

    private static ReferenceRun replay(SimulationSetup setup, long ticks) {
        return ReferenceRun.replay(new Journal(setup, List.of(), ticks), tick -> true);
    }

    @Test
    void theCaptionSaysThatAControllerFromOutsideIgnoresAPlannedChange() throws Exception {
        SimulationSetup office = Scenario.loadShipped("office.xml").setup();
        SimulationSetup.TimedCommand change = new SimulationSetup.TimedCommand(
                0.5, new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT));
        String expected =
                "Command refused at 0.50 s: the controller is not part of the program and has no settings here";
        assertTrue(caption(replay(office.withTimeline(List.of(change)), 100)).stream()
                .noneMatch(line -> line.contains("refused")));
        SimulationSetup foreign = office.withController(new ControllerSpec.Chosen(office.controller(), STANDING));
        List<String> one = caption(replay(foreign.withTimeline(List.of(change)), 100));
        assertEquals(expected, one.get(one.size() - 1));
        List<String> two = caption(replay(foreign.withTimeline(List.of(change, change)), 100));
        assertEquals(expected + " (further ones: 1)", two.get(two.size() - 1));
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
