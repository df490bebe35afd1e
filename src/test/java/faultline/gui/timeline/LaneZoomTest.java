package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** A run of 100 s with ticks of 0.01 s on 1000 pixels. */
class LaneZoomTest {

    private final LaneZoom zoom = new LaneZoom(() -> 0.01);

    LaneZoomTest() {
        zoom.alignWith(new TimeAxis(0, 1000, 100));
    }

    private void assertShown(double start, double end) {
        assertEquals(start, zoom.axis().start(), 1e-9);
        assertEquals(end, zoom.axis().end(), 1e-9);
    }

    @Test
    void stepsInAndOutEndWhereTheyBegan() {
        for (int i = 0; i < 7; i++) {
            zoom.zoomAbout(1, 40);
        }
        assertEquals(400, zoom.axis().x(40), 1e-6);
        assertFalse(zoom.axis().isWhole());
        for (int i = 0; i < 7; i++) {
            zoom.zoomAbout(-1, 40);
        }
        assertTrue(zoom.axis().isWhole(), zoom.axis().toString());
    }

    @Test
    void withoutTheTimeInViewTheMiddleStays() {
        show(10, 20);
        zoom.zoomAbout(1, 90);
        assertShown(11, 19);
    }

    @Test
    void theSmallestPartIsTwentyTicks() {
        zoom.zoom(100, 500);
        assertEquals(0.2, zoom.axis().length(), 1e-9);
        assertFalse(zoom.canZoomIn());
        zoom.zoom(1, 500);
        assertEquals(0.2, zoom.axis().length(), 1e-9);
        zoom.showAll();
        assertTrue(zoom.canZoomIn());
        assertShown(0, 100);
    }

    @Test
    void theLanesFollowTheTimeThatWasVisible() {
        show(10, 20);
        zoom.follow(19.9, 20);
        assertShown(10, 20);
        zoom.follow(20, 20.1);
        assertShown(19.1, 29.1);
        zoom.follow(25, 3);
        assertShown(2, 12);
    }

    @Test
    void theLanesStayWhereTheUserHasScrolledUntilTheTimeIsVisibleAgain() {
        show(10, 20);
        zoom.follow(30, 30.1);
        assertShown(10, 20);
        zoom.moveTo(25);
        zoom.follow(30.1, 36);
        assertShown(35, 45);
    }

    @Test
    void onlyAnItemThatIsNotVisibleIsMovedTo() {
        show(10, 20);
        zoom.showItem(fault(5, 10));
        assertShown(10, 20);
        zoom.showItem(fault(15, Double.POSITIVE_INFINITY));
        assertShown(10, 20);
        zoom.showItem(fault(50, 60));
        assertShown(49, 59);
        zoom.showItem(fault(20, 30));
        assertShown(19, 29);
    }

    @Test
    void listenersHearOnlyOfChanges() {
        AtomicInteger changes = new AtomicInteger();
        zoom.addListener(changes::incrementAndGet);
        zoom.showTime(30);
        zoom.move(50);
        zoom.zoom(-1, 500);
        assertEquals(0, changes.get(), "all of the run is visible");
        zoom.zoom(1, 500);
        assertEquals(1, changes.get());
    }

    private void show(double start, double end) {
        zoom.zoom(Math.log(100 / (end - start)) / Math.log(1.25), 0);
        zoom.moveTo(start);
        assertShown(start, end);
    }

    private static TimelineItem fault(double start, double end) {
        return new TimelineItem(new Command.InjectFault("left", new Fault.Stuck(0.4)), start, end);
    }
}
