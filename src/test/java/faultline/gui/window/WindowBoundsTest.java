package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Rectangle;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Where the window opens that was closed at some bounds. */
class WindowBoundsTest {

    private static final Rectangle LAPTOP = new Rectangle(0, 0, 1280, 720);
    private static final Rectangle MONITOR = new Rectangle(1280, 0, 1920, 1080);

    private static Optional<Rectangle> onScreen(Rectangle bounds, Rectangle... screens) {
        return WindowBounds.onScreen(bounds, Stream.of(screens));
    }

    @Test
    void boundsOfAScreenThatIsThereAreKept() {
        Rectangle centred = new Rectangle(100, 50, 1024, 600);
        assertEquals(Optional.of(centred), onScreen(centred, LAPTOP));
        Rectangle large = new Rectangle(1300, 20, 1800, 1000);
        assertEquals(Optional.of(large), onScreen(large, LAPTOP, MONITOR));
        Rectangle partlyOutside = new Rectangle(1100, 600, 1024, 600);
        assertEquals(Optional.of(partlyOutside), onScreen(partlyOutside, LAPTOP));
    }

    @Test
    void boundsLargerThanTheScreenAreReducedToIt() {
        assertEquals(Optional.of(LAPTOP), onScreen(new Rectangle(40, 30, 1800, 1000), LAPTOP));
        assertEquals(
                Optional.of(new Rectangle(100, 0, 1024, 720)), onScreen(new Rectangle(100, 30, 1024, 768), LAPTOP));
    }

    @Test
    void boundsWhoseTitleBarIsOnNoScreenAreNotUsed() {
        assertEquals(Optional.empty(), onScreen(new Rectangle(1300, 20, 1800, 1000), LAPTOP));
        assertEquals(Optional.empty(), onScreen(new Rectangle(100, -30, 1024, 600), LAPTOP));
    }
}
