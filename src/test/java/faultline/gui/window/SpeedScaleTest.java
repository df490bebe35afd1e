package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SpeedScaleTest {

    @Test
    void theScaleGoesFromATenthOverRealTimeToAHundredAndThenAsFastAsPossible() {
        assertEquals(0.1, SpeedScale.speed(0), 1e-12);
        assertEquals(1, SpeedScale.speed(SpeedScale.REAL_TIME));
        assertEquals(100, SpeedScale.speed(SpeedScale.MOST - 1), 1e-9);
        assertEquals(Double.POSITIVE_INFINITY, SpeedScale.speed(SpeedScale.MOST));
    }

    @Test
    void realTimeHasThreePositionsAndEveryOtherSpeedOne() {
        for (int position = 1; position <= SpeedScale.MOST; position++) {
            double below = SpeedScale.speed(position - 1);
            double here = SpeedScale.speed(position);
            assertTrue(here > below || here == 1 && below == 1, "at " + position);
        }
        assertEquals(1, SpeedScale.speed(SpeedScale.REAL_TIME - 1));
        assertEquals(1, SpeedScale.speed(SpeedScale.REAL_TIME + 1));
    }

    @Test
    void eachPressOfAKeyIsAnotherSpeedAndStopsAtTheEnds() {
        int presses = 0;
        for (int position = 0; position < SpeedScale.MOST; presses++) {
            int next = SpeedScale.faster(position);
            assertTrue(SpeedScale.speed(next) > SpeedScale.speed(position));
            position = next;
        }
        assertEquals(31, presses);
        assertEquals(SpeedScale.MOST, SpeedScale.faster(SpeedScale.MOST));
        assertEquals(0, SpeedScale.slower(0));
        assertEquals(SpeedScale.REAL_TIME, SpeedScale.slower(SpeedScale.faster(SpeedScale.REAL_TIME)));
    }

    @Test
    void speedsAreWrittenWithoutNoise() {
        assertEquals("0.125×", SpeedScale.text(SpeedScale.speed(1)));
        assertEquals("1×", SpeedScale.text(1));
        assertEquals("80×", SpeedScale.text(SpeedScale.speed(SpeedScale.MOST - 2)));
    }
}
