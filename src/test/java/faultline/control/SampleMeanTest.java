package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

class SampleMeanTest {

    private final SampleMean mean = new SampleMean();

    @Test
    void aSampleByItselfIsItsOwnMean() {
        mean.start(1);
        assertTrue(mean.completes(0.7, 0.3));
        assertEquals(0.7, mean.clock());
        assertEquals(0.3, mean.reading());
    }

    @Test
    void ofThreeSamplesTheThirdCompletesTheMean() {
        mean.start(3);
        assertFalse(mean.completes(1, 0.1));
        assertFalse(mean.completes(2, 0.2));
        assertTrue(mean.completes(3, 0.6));
        assertEquals(2, mean.clock(), 1e-12);
        assertEquals(0.3, mean.reading(), 1e-12);
    }

    @Test
    void oneSampleOfNothingMakesTheMeanNothing() {
        mean.start(2);
        mean.completes(1, Reading.NOTHING);
        mean.completes(2, 0.5);
        assertEquals(Reading.NOTHING, mean.reading());
    }

    @Test
    void anewMeansWithoutWhatWasTakenBefore() {
        mean.start(2);
        mean.completes(1, 0.1);
        mean.start(2);
        assertFalse(mean.completes(5, 0.4));
        assertTrue(mean.completes(7, 0.4));
        assertEquals(6, mean.clock(), 1e-12);
    }
}
