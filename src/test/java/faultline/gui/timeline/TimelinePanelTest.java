package faultline.gui.timeline;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.Theme;
import org.junit.jupiter.api.Test;

class TimelinePanelTest {

    /** Creates a panel of 800 x 400 pixels that is laid out. */
    private static TimelinePanel createPanel() {
        Theme.LIGHT.install();
        RunController run = new RunController(new Workspace());
        UndoController undo = new UndoController(run::send, () -> {});
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
}
