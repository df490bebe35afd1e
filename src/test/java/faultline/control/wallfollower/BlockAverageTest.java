package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

class BlockAverageTest {

    private final BlockAverage average = new BlockAverage();

    @Test
    void aSampleByItselfIsItsOwnMean() {
        average.start(1);
        assertTrue(average.add(0.7, 0.3));
        assertEquals(0.7, average.clock());
        assertEquals(0.3, average.reading());
    }

    @Test
    void ofThreeSamplesTheThirdCompletesTheMean() {
        average.start(3);
        assertFalse(average.add(1, 0.1));
        assertFalse(average.add(2, 0.2));
        assertTrue(average.add(3, 0.6));
        assertEquals(2, average.clock(), 1e-12);
        assertEquals(0.3, average.reading(), 1e-12);
    }

    @Test
    void oneSampleOfNothingMakesTheMeanNothing() {
        average.start(2);
        average.add(1, Reading.NOTHING);
        average.add(2, 0.5);
        assertEquals(Reading.NOTHING, average.reading());
    }

    @Test
    void restartingDropsTheSamplesTakenBefore() {
        average.start(2);
        average.add(1, 0.1);
        average.start(2);
        assertFalse(average.add(5, 0.4));
        assertTrue(average.add(7, 0.4));
        assertEquals(6, average.clock(), 1e-12);
    }
}
