package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.GuiRobot;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests F6 with areas that receive the focus late. */
class FocusAreasTest {

    private final List<String> requests = new ArrayList<>();
    private final List<Area> areas =
            Stream.of("canvas", "slider", "lanes", "panel").map(Area::new).toList();
    private FocusAreas focus;

    @BeforeEach
    void build() {
        focus = new FocusAreas(List.copyOf(areas));
    }

    @Test
    void keysPressedBeforeTheFocusArrivesCount() {
        move(1, 1, 1);
        assertEquals(List.of("canvas", "slider", "lanes"), requests);
    }

    @Test
    void keysGoRoundInBothDirections() {
        move(-1, -1, 1, 1);
        assertEquals(List.of("panel", "lanes", "panel", "canvas"), requests);
    }

    @Test
    void hiddenAreasAreLeftOut() {
        areas.get(1).shown = false;
        move(1, 1, 1);
        assertEquals(List.of("canvas", "lanes", "panel"), requests);
    }

    @Test
    void anAreaHiddenAfterTheRequestIsForgotten() {
        move(1, 1);
        areas.get(1).shown = false;
        move(1);
        assertEquals(List.of("canvas", "slider", "canvas"), requests);
    }

    @Test
    void theFocusCountsOnceItHasArrived() {
        move(1, 1);
        FocusEvent gained =
                new FocusEvent(areas.get(1), FocusEvent.FOCUS_GAINED, false, null, FocusEvent.Cause.TRAVERSAL);
        Stream.of(areas.get(1).getFocusListeners()).forEach(listener -> listener.focusGained(gained));
        // No component of a window without display owns the focus: the first area follows.
        move(1);
        assertEquals(List.of("canvas", "slider", "canvas"), requests);
    }

    private void move(int... steps) {
        GuiRobot.runOnEdt(() -> {
            for (int step : steps) {
                focus.move(step);
            }
        });
    }

    /** An area that records focus requests and receives the focus only from the test. */
    private final class Area extends JPanel {

        private boolean shown = true;

        Area(String name) {
            setName(name);
        }

        @Override
        public boolean isShowing() {
            return shown;
        }

        @Override
        public boolean requestFocusInWindow(FocusEvent.Cause cause) {
            requests.add(getName());
            return true;
        }
    }
}
