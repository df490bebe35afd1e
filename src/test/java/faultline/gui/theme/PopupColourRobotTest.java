package faultline.gui.theme;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;

import java.awt.Window;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;

/** The colour of a list before its first paint. */
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "opens a real window, which needs a display")
class PopupColourRobotTest {

    private final JFrame[] frame = new JFrame[1];

    @AfterEach
    void close() {
        runOnEdt(() -> {
            frame[0].dispose();
            Theme.LIGHT.install();
        });
    }

    @Test
    void aListInAWindowOfItsOwnHasTheColourOfTheTheme() {
        runOnEdt(() -> {
            Theme.DARK.install();
            JComboBox<String> box = new JComboBox<>(new String[] {"front", "left", "rear", "right"});
            box.setLightWeightPopupEnabled(false);
            frame[0] = new JFrame();
            frame[0].add(box);
            frame[0].pack();
            frame[0].setVisible(true);
            box.showPopup();
            JComponent list = (JComponent) box.getUI().getAccessibleChild(box, 0);
            Window window = SwingUtilities.getWindowAncestor(list);
            assertNotSame(frame[0], window);
            assertEquals(Theme.DARK.colours().background(), window.getBackground());
        });
    }
}
