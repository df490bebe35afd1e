package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.theme.Theme;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

/** The banner at the end of a run without a display. */
class VerdictBannerTest {

    private static final String LONG =
            "End of the run at 30.000 s: everything that was expected held, from the start on";

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
}
