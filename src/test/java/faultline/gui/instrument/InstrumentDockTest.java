package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.session.SessionFrame;
import faultline.gui.ComponentFinder;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;

/** The instruments without a display. */
class InstrumentDockTest {

    private static final SessionFrame FRAME = SampleRuns.frame(1000);

    private final InstrumentDock dock = callOnEdt(() -> new InstrumentDock(tick -> {}));

    private void poll(SessionFrame frame, int times) {
        runOnEdt(() -> {
            for (int i = 0; i < times; i++) {
                dock.setFrame(frame);
            }
        });
    }

    private int rows() {
        return callOnEdt(() -> ComponentFinder.findAll(dock, JTable.class)
                .findFirst()
                .orElseThrow()
                .getRowCount());
    }

    @Test
    void onlyTheChosenTabIsKeptUpToDate() {
        poll(FRAME, 3);
        assertEquals(0, rows());
        runOnEdt(() -> dock.setSelectedIndex(2));
        assertTrue(rows() > 5);
    }

    @Test
    void aFrameIsShownSoonEvenIfItIsTheLast() {
        runOnEdt(() -> dock.setSelectedIndex(2));
        poll(SampleRuns.frame(100), 3);
        int before = rows();
        poll(FRAME, 2);
        assertEquals(before, rows());
        poll(FRAME, 1);
        assertTrue(rows() > before);
    }

    @Test
    void theWidthOfTheChartIsRememberedOnlyIfTheUserHasChosenIt() {
        runOnEdt(() -> {
            dock.setSize(900, 200);
            dock.doLayout();
            dock.split().doLayout();
        });
        assertEquals(Optional.empty(), callOnEdt(dock::chosenChartWidth));
        runOnEdt(() -> dock.setChartWidth(250));
        assertEquals(Optional.empty(), callOnEdt(dock::chosenChartWidth));
        runOnEdt(() -> dock.split().setDividerLocation(300));
        assertEquals(Optional.of(300), callOnEdt(dock::chosenChartWidth));
    }

    @Test
    void everythingThatShowsSomethingHasANameForReadersOfTheScreen() {
        List<JComponent> shown = Stream.of(
                        JTabbedPane.class,
                        JTable.class,
                        StripView.class,
                        StateDiagramView.class,
                        AlignmentView.class,
                        JComboBox.class,
                        JToggleButton.class)
                .<JComponent>flatMap(type -> ComponentFinder.findAll(dock, type))
                .toList();
        assertTrue(shown.size() >= 7, "found only " + shown.size());
        shown.forEach(
                part -> assertFalse(ComponentFinder.accessibleName(part).isEmpty(), part.getClass() + " has no name"));
    }
}
