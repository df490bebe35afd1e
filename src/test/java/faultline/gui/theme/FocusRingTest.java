package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Graphics2D;
import java.awt.event.FocusEvent;
import java.awt.image.BufferedImage;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The ring shows the component that gained the focus by keyboard. */
class FocusRingTest {

    private static final int BARE = 0xFF000000;

    private final JPanel panel = callOnEdt(() -> {
        Theme.LIGHT.install();
        JPanel made = new JPanel();
        made.setSize(40, 30);
        return made;
    });
    private final FocusRing ring = callOnEdt(() -> new FocusRing(panel));

    @ParameterizedTest
    @CsvSource({"TRAVERSAL_FORWARD, true", "TRAVERSAL_BACKWARD, true", "MOUSE_EVENT, false", "ACTIVATION, false"})
    void focusFromTheKeyboardShowsTheRing(FocusEvent.Cause cause, boolean ringed) {
        runOnEdt(() -> ring.focusGained(event(FocusEvent.FOCUS_GAINED, cause)));
        assertEquals(ringed ? Theme.LIGHT.colours().accent().getRGB() : BARE, edge());
    }

    @Test
    void theRingDisappearsWithTheFocus() {
        runOnEdt(() -> ring.focusGained(event(FocusEvent.FOCUS_GAINED, FocusEvent.Cause.TRAVERSAL_FORWARD)));
        runOnEdt(() -> ring.focusLost(event(FocusEvent.FOCUS_LOST, FocusEvent.Cause.UNKNOWN)));
        assertEquals(BARE, edge());
    }

    @ParameterizedTest
    @CsvSource({
        "TRAVERSAL_FORWARD, UNKNOWN, true",
        "TRAVERSAL_FORWARD, ACTIVATION, true",
        "TRAVERSAL_FORWARD, MOUSE_EVENT, false",
        "MOUSE_EVENT, UNKNOWN, false"
    })
    void theRingReturnsWithTheFocusFromAMenu(FocusEvent.Cause before, FocusEvent.Cause after, boolean ringed) {
        runOnEdt(() -> {
            ring.focusGained(event(FocusEvent.FOCUS_GAINED, before));
            ring.focusLost(new FocusEvent(panel, FocusEvent.FOCUS_LOST, true, null, FocusEvent.Cause.UNKNOWN));
        });
        assertEquals(BARE, edge(), "the menu has the focus");
        runOnEdt(() -> ring.focusGained(event(FocusEvent.FOCUS_GAINED, after)));
        assertEquals(ringed ? Theme.LIGHT.colours().accent().getRGB() : BARE, edge());
    }

    private FocusEvent event(int id, FocusEvent.Cause cause) {
        return new FocusEvent(panel, id, false, null, cause);
    }

    private int edge() {
        return callOnEdt(() -> {
            BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            ring.paint(graphics);
            graphics.dispose();
            return image.getRGB(20, 1);
        });
    }
}
