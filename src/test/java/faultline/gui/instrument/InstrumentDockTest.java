package faultline.gui.instrument;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.gui.Components;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.JTabbedPane;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;

/** The dock without a display. */
class InstrumentDockTest {

    private static final Frame FRAME = Runs.frame(1000);

    private final InstrumentDock dock = onEdt(() -> new InstrumentDock(tick -> { }));

    private void poll(Frame frame, int times) {
        edt(() -> {
            for (int i = 0; i < times; i++) {
                dock.show(frame);
            }
        });
    }

    private int rows() {
        return onEdt(() -> Components.all(dock, JTable.class).findFirst().orElseThrow().getRowCount());
    }

    @Test
    void onlyTheChosenTabIsKeptUpToDate() {
        poll(FRAME, 3);
        assertEquals(0, rows());
        edt(() -> dock.setSelectedIndex(2));
        assertTrue(rows() > 5);
    }

    @Test
    void aFrameIsShownSoonEvenIfItIsTheLast() {
        edt(() -> dock.setSelectedIndex(2));
        poll(Runs.frame(100), 3);
        int before = rows();
        poll(FRAME, 2);
        assertEquals(before, rows());
        poll(FRAME, 1);
        assertTrue(rows() > before);
    }

    @Test
    void everythingThatShowsSomethingHasANameForReadersOfTheScreen() {
        List<JComponent> shown = Stream.of(JTabbedPane.class, JTable.class, StripView.class, StateDiagramView.class,
                TimingInstrument.class, JComboBox.class,
                JToggleButton.class).<JComponent>flatMap(type -> Components.all(dock, type)).toList();
        assertTrue(shown.size() >= 7, "found only " + shown.size());
        shown.forEach(part -> assertFalse(Components.name(part).isEmpty(), part.getClass() + " has no name"));
    }
}
