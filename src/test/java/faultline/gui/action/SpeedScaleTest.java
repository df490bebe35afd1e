package faultline.gui.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SpeedScaleTest {

    @Test
    void theScaleRangesFromATenthToAHundredTimesRealTimeAndEndsAtUnlimitedSpeed() {
        assertEquals(0.1, SpeedScale.speedAt(0), 1e-12);
        assertEquals(1, SpeedScale.speedAt(SpeedScale.REAL_TIME_POSITION));
        assertEquals(100, SpeedScale.speedAt(SpeedScale.UNLIMITED - 1), 1e-9);
        assertEquals(Double.POSITIVE_INFINITY, SpeedScale.speedAt(SpeedScale.UNLIMITED));
    }

    @Test
    void realTimeHasThreePositionsAndEveryOtherSpeedHasOne() {
        for (int position = 1; position <= SpeedScale.UNLIMITED; position++) {
            double below = SpeedScale.speedAt(position - 1);
            double here = SpeedScale.speedAt(position);
            assertTrue(here > below || here == 1 && below == 1, "at " + position);
        }
        assertEquals(1, SpeedScale.speedAt(SpeedScale.REAL_TIME_POSITION - 1));
        assertEquals(1, SpeedScale.speedAt(SpeedScale.REAL_TIME_POSITION + 1));
    }

    @Test
    void eachKeyPressChangesTheSpeedUpToTheEndsOfTheScale() {
        int presses = 0;
        for (int position = 0; position < SpeedScale.UNLIMITED; presses++) {
            int next = SpeedScale.nextFaster(position);
            assertTrue(SpeedScale.speedAt(next) > SpeedScale.speedAt(position));
            position = next;
        }
        assertEquals(31, presses);
        assertEquals(SpeedScale.UNLIMITED, SpeedScale.nextFaster(SpeedScale.UNLIMITED));
        assertEquals(0, SpeedScale.nextSlower(0));
        assertEquals(
                SpeedScale.REAL_TIME_POSITION,
                SpeedScale.nextSlower(SpeedScale.nextFaster(SpeedScale.REAL_TIME_POSITION)));
    }

    @Test
    void speedsAreFormattedWithoutTrailingDigits() {
        assertEquals("0.125×", SpeedScale.format(SpeedScale.speedAt(1)));
        assertEquals("1×", SpeedScale.format(1));
        assertEquals("80×", SpeedScale.format(SpeedScale.speedAt(SpeedScale.UNLIMITED - 2)));
    }
}
