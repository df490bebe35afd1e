package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** An axis of 50 seconds on 200 pixels. */
class TimeAxisTest {

    private static final TimeAxis AXIS = new TimeAxis(30, 230, 50);

    @ParameterizedTest
    @CsvSource({"0, 30", "25, 130", "50, 230"})
    void aTimeAndItsCoordinateAreConverted(double time, double x) {
        assertEquals(x, AXIS.x(time));
        assertEquals(time, AXIS.timeAt(x));
    }

    @Test
    void whatIsBeyondTheAxisIsAtItsEnd() {
        assertEquals(230, AXIS.x(60));
        assertEquals(50, AXIS.timeAt(300));
        assertEquals(0, AXIS.timeAt(-10));
    }

    /** Two pixels are half a second. */
    @ParameterizedTest
    @CsvSource({"0.01, 0.5", "0.7, 1", "1, 1"})
    void aStepIsANiceNumberOfAtLeastATickAndTwoPixels(double tick, double step) {
        assertEquals(step, AXIS.step(tick));
    }

    /** Two pixels are 0.51 s. */
    @Test
    void theNextNiceNumberIsTakenIfTheLastIsLessThanTwoPixels() {
        assertEquals(1, new TimeAxis(30, 230, 51).step(0.01));
    }

    /** 100 pixels are 25 s; the time there is in the middle. */
    @Test
    void aZoomKeepsTheTimeAtItsPlace() {
        TimeAxis zoomed = AXIS.zoomed(0.5, 130, 0.2);
        assertEquals(new TimeAxis(30, 230, 12.5, 37.5, 50), zoomed);
        assertEquals(130, zoomed.x(25));
        assertEquals(-70, zoomed.x(0), "before the axis");
        assertEquals(330, zoomed.x(60), "the end of the run");
        assertTrue(zoomed.shows(12.5) && zoomed.shows(37.5) && !zoomed.shows(12.4) && !zoomed.shows(60));
        assertEquals(AXIS, zoomed.zoomed(4, 130, 0.2));
    }

    @Test
    void aTimeIsShownWithWhatFollowsIt() {
        TimeAxis part = new TimeAxis(30, 230, 10, 20, 50);
        assertEquals(part, part.showing(20));
        assertEquals(new TimeAxis(30, 230, 29, 39, 50), part.showing(30));
        assertEquals(new TimeAxis(30, 230, 4, 14, 50), part.showing(5));
        assertEquals(new TimeAxis(30, 230, 0, 10, 50), part.showing(0));
        assertEquals(new TimeAxis(30, 230, 40, 50, 50), part.showing(Double.POSITIVE_INFINITY));
    }

    /** 20 pixels are a second. */
    @Test
    void aPartIsMovedByPixelsUpToTheEndsOfTheRun() {
        TimeAxis part = new TimeAxis(30, 230, 10, 20, 50);
        assertEquals(new TimeAxis(30, 230, 12, 22, 50), part.moved(40));
        assertEquals(new TimeAxis(30, 230, 7, 17, 50), part.moved(-60));
        assertEquals(new TimeAxis(30, 230, 0, 10, 50), part.moved(-300));
        assertEquals(new TimeAxis(30, 230, 40, 50, 50), part.moved(3000));
    }

    @Test
    void aPartStaysWhenTheRunGrowsAndTheWholeRunStaysWhole() {
        TimeAxis longer = new TimeAxis(30, 430, 60);
        assertEquals(new TimeAxis(30, 430, 10, 20, 60), new TimeAxis(30, 230, 10, 20, 50).alignedWith(longer));
        assertEquals(longer, AXIS.alignedWith(longer));
        TimeAxis shorter = new TimeAxis(30, 230, 15);
        assertEquals(new TimeAxis(30, 230, 5, 15, 15), new TimeAxis(30, 230, 10, 20, 50).alignedWith(shorter));
    }

    @Test
    void afterAnyZoomsAndMovesThePartIsInTheRunAndItsPixelsAndTimesAreConverted() {
        Random random = new Random(5);
        for (int trial = 0; trial < 200; trial++) {
            double runEnd = Math.pow(10, random.nextDouble() * 5 - 1);
            double least = runEnd / (1 + random.nextInt(1000));
            TimeAxis axis = new TimeAxis(80, 80 + 1 + random.nextInt(1500), runEnd);
            for (int i = 0; i < 30; i++) {
                double x = axis.left() + random.nextDouble() * (axis.right() - axis.left());
                double before = axis.timeAt(x);
                double factor = Math.pow(1.25, random.nextInt(11) - 5);
                boolean zooms = random.nextBoolean();
                TimeAxis next = zooms ? axis.zoomed(factor, x, least) : axis.moved(random.nextInt(400) - 200);
                boolean inner = next.start() > 0 && next.end() < runEnd;
                if (zooms && inner) {
                    assertEquals(x, next.x(before), 1e-6);
                }
                axis = next;
                assertTrue(axis.start() >= 0 && axis.end() <= runEnd && axis.start() < axis.end(), axis.toString());
                assertTrue(axis.length() >= least * (1 - 1e-6), axis + " of at least " + least);
                assertEquals(x, axis.x(axis.timeAt(x)), 1e-6);
            }
        }
    }

    @Test
    void anEmptyRunHasAnAxis() {
        TimeAxis empty = new TimeAxis(30, 30, 0);
        assertEquals(30, empty.x(0));
        assertEquals(31, empty.x(1));
        assertEquals(0, empty.timeAt(30));
    }
}
