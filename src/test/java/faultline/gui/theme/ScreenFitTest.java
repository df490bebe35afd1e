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

    @Test
    void aDialogThatScrollsDownHasRoomForItsScrollBar() {
        Dimension screen = new Dimension(640, 480);
        assertEquals(new Dimension(551, 432), ScreenFit.fit(new Dimension(538, 560), screen, 13));
        assertEquals(new Dimension(624, 432), ScreenFit.fit(new Dimension(620, 560), screen, 13));
        assertEquals(new Dimension(538, 300), ScreenFit.fit(new Dimension(538, 300), screen, 13));
    }
}
