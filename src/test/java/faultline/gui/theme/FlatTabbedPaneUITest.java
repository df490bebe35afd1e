package faultline.gui.theme;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import org.junit.jupiter.api.Test;

/** Tabs in two rows, because their pane is narrow. */
class FlatTabbedPaneUITest {

    private static final int TABS = 4;

    private static JTabbedPane narrowPane() {
        Theme.LIGHT.install();
        JTabbedPane pane = new JTabbedPane();
        IntStream.range(0, TABS).forEach(tab -> pane.addTab("Tab " + tab, new JPanel()));
        pane.setSize(165, 200);
        pane.doLayout();
        assertEquals(2, pane.getTabRunCount());
        return pane;
    }

    private static void press(JTabbedPane pane, String navigation) {
        pane.getActionMap().get(navigation).actionPerformed(new ActionEvent(pane, 0, navigation));
    }

    @Test
    void rightAndLeftReachTheTabsOfEveryRow() {
        runOnEdt(() -> {
            JTabbedPane pane = narrowPane();
            for (int tab = 1; tab < TABS; tab++) {
                press(pane, "navigateRight");
                assertEquals(tab, pane.getSelectedIndex());
            }
            for (int tab = TABS - 2; tab >= 0; tab--) {
                press(pane, "navigateLeft");
                assertEquals(tab, pane.getSelectedIndex());
            }
        });
    }

    @Test
    void noTabMovesWhenAnotherIsSelected() {
        runOnEdt(() -> {
            JTabbedPane pane = narrowPane();
            List<Rectangle> before = places(pane);
            for (int tab = 0; tab < TABS; tab++) {
                pane.setSelectedIndex(tab);
                pane.doLayout();
                assertEquals(before, places(pane), "tab " + tab);
            }
        });
    }

    private static List<Rectangle> places(JTabbedPane pane) {
        return IntStream.range(0, TABS).mapToObj(pane::getBoundsAt).toList();
    }
}
