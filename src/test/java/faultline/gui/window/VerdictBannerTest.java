package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Component;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The banner at the end of a run without a display. */
class VerdictBannerTest {

    private static final String LONG =
            "End of the run at 30.000 s: everything that was expected held, from the start on";

    @AfterEach
    void restoreTextSize() {
        runOnEdt(TextSize.NORMAL::install);
    }

    private static int height(int width, String title) {
        return callOnEdt(() -> {
            Theme.LIGHT.install();
            JPanel parent = new JPanel();
            parent.setSize(width, 400);
            VerdictBanner banner = new VerdictBanner(tick -> {});
            parent.add(banner);
            banner.setVerdict(new RunVerdict(true, title, "", -1), 0.01);
            return banner.getPreferredSize().height;
        });
    }

    @Test
    void aLongTitleContinuesOnTheNextLine() {
        assertTrue(height(420, LONG) > height(420, "End of the run"));
        assertEquals(height(1600, "End of the run"), height(1600, LONG));
    }

    @Test
    void theButtonIsMissingIfThereIsNothingBeforeTheEvent() {
        assertTrue(hasBackButton(1));
        assertFalse(hasBackButton(0));
    }

    private static boolean hasBackButton(long event) {
        return callOnEdt(() -> {
            VerdictBanner banner = new VerdictBanner(tick -> {});
            banner.setVerdict(new RunVerdict(false, "Collision", "", event), 0.01);
            return backButton(banner).isVisible();
        });
    }

    private static JButton backButton(VerdictBanner banner) {
        return ComponentFinder.findAll(banner, JButton.class)
                .filter(button -> Messages.get("verdict.back").equals(button.getText()))
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @EnumSource(TextSize.class)
    void theButtonIsBelowTheTextsWhereItWouldTakeMoreRoomThanThey(TextSize size) {
        runOnEdt(() -> {
            size.install();
            Theme.LIGHT.install();
            JPanel parent = new JPanel(null);
            VerdictBanner banner = new VerdictBanner(tick -> {});
            parent.add(banner);
            parent.setSize(1600, 400);
            banner.setVerdict(new RunVerdict(false, LONG, "Collision with the pole after 9.562 s", 956), 0.01);
            int before = Integer.MAX_VALUE;
            for (int width : new int[] {1600, 300}) {
                parent.setSize(width, 400);
                banner.setSize(width, banner.getPreferredSize().height);
                ComponentFinder.tree(banner).forEach(Component::doLayout);
                JTextArea detail = ComponentFinder.findAll(banner, JTextArea.class)
                        .toList()
                        .get(1);
                JButton back = backButton(banner);
                assertTrue(detail.getWidth() >= back.getWidth(), "at " + width);
                assertTrue(detail.getWidth() < before);
                before = detail.getWidth();
            }
        });
    }
}
