package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

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

    @Test
    void anEmptyRunHasAnAxis() {
        TimeAxis empty = new TimeAxis(30, 30, 0);
        assertEquals(30, empty.x(0));
        assertEquals(31, empty.x(1));
        assertEquals(0, empty.timeAt(30));
    }
}
