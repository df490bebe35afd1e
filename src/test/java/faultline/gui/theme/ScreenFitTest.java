package faultline.gui.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Dimension;
import org.junit.jupiter.api.Test;

class ScreenFitTest {

    @Test
    void aDialogNeverExceedsTheScreen() {
        assertEquals(new Dimension(756, 552), ScreenFit.limit(new Dimension(756, 640), new Dimension(800, 600)));
        assertEquals(new Dimension(300, 200), ScreenFit.limit(new Dimension(300, 200), new Dimension(800, 600)));
    }
}
