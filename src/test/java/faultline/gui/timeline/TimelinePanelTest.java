package faultline.gui.timeline;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.Recorder;
import faultline.engine.session.SessionFrame;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import org.junit.jupiter.api.Test;

class TimelinePanelTest {

    /** Creates a panel of 800 x 400 pixels that is laid out. */
    private static TimelinePanel createPanel() {
        Theme.LIGHT.install();
        RunController run = new RunController(new Workspace());
        UndoController undo = new UndoController(new CommandSender(run::send), () -> {});
        TimelinePanel panel =
                new TimelinePanel(tick -> {}, frame -> {}, new TimelineEditor(new Workspace(), run, undo));
        panel.addNotify();
        panel.setSize(800, 400);
        panel.validate();
        return panel;
    }

    @Test
    void theLanesOfTheDefaultRobotStandDisabledBeforeThereIsAScenario() {
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            LaneLayout lanes = panel.lanes().lanes();
            assertEquals(11, lanes.lanes().size(), "eight sensors, two sides of motors, and all else");
            assertEquals("front", lanes.lanes().get(0).label());
            assertTrue(lanes.axis().left() > 60, "room for the names, " + lanes.axis());
            assertFalse(panel.lanes().isEnabled());
            panel.removeNotify();
        });
    }

    /** A window that another program resizes has no newer frame at pause. */
    @Test
    void theLanesStayAlignedWithTheSliderOfAnotherWidthWithoutAFrame() {
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            panel.lanes().update(panel.lanes().lanes().lanes(), panel.bar().axis(), 0);
            double before = panel.lanes().axis().right();
            panel.setSize(1000, 400);
            panel.validate();
            assertEquals(before + 200, panel.lanes().axis().right());
            panel.removeNotify();
        });
    }

    /** Their texts take time, and the run may continue for hours. */
    @Test
    void aFramePastTheEndOfTheScenarioMakesNoNewMarks() throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("office.xml").setup().withDuration(0.05);
        Recorder recorder = new Recorder(setup);
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT, recorder)) {
            runOnEdt(() -> {
                TimelinePanel panel = createPanel();
                EventStops stops = null;
                while (simulation.frame().snapshot().tick() < setup.ticks() + 3) {
                    simulation.tick();
                    recorder.observe(simulation);
                    SessionFrame frame = new SessionFrame(simulation.frame(), recorder.view());
                    long last = Math.max(frame.snapshot().tick(), setup.ticks());
                    panel.setFrame(frame, last, setup.ticks(), setup.dt());
                    assertEquals(last, panel.bar().end());
                    assertTrue(stops == null || stops == panel.stops(), "new marks at tick " + last);
                    stops = panel.stops();
                }
                panel.removeNotify();
            });
        }
    }
}
