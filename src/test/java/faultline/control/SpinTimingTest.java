package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.sensor.Reading;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Spins past walls that are given as readings over time, sampled every 0.1 s from 0. */
class SpinTimingTest {

    private static final double STEP = 0.1;
    private static final int MOST = 200;

    /** Of the robot in a step: too much for two samples to be averaged. */
    private static final double TURN = Math.toRadians(3);

    private static SpinTiming spin(Timing rule, double noise, DoubleUnaryOperator readings) {
        SpinTiming timing = new SpinTiming(rule);
        timing.start(noise, TURN);
        int i = 0;
        do {
            timing.approach(i * STEP, readings.applyAsDouble(i * STEP), 0);
        } while (!timing.comesToWall() && ++i < MOST);
        do {
            i++;
            timing.pass(i * STEP, readings.applyAsDouble(i * STEP));
        } while (!timing.leavesWall() && i < MOST);
        assertTrue(i < MOST, "the wall was not timed");
        return timing;
    }

    /** A wall that is nearest, 0.25 m, at a moment, and farther by 0.1 m for every second before and after; seen up to 0.45 m. */
    private static DoubleUnaryOperator wallAt(double moment) {
        return t -> {
            double reading = 0.25 + 0.1 * Math.abs(t - moment);
            return reading <= 0.45 ? reading : Reading.NOTHING;
        };
    }

    @Test
    void beforeASpinNoMomentIsKnown() {
        SpinTiming timing = new SpinTiming(Timing.EQUAL_READINGS);
        assertTrue(Double.isNaN(timing.tF3()) && Double.isNaN(timing.tF4()) && Double.isNaN(timing.tP()));
    }

    @Test
    void equalReadingsLieEvenlyOnEitherSideOfTheNearestEvenBetweenSamples() {
        for (double moment : new double[] {3, 3.02, 3.05, 3.09}) {
            SpinTiming timing = spin(Timing.EQUAL_READINGS, 0, wallAt(moment));
            assertEquals(moment, (timing.tF3() + timing.tF4()) / 2, 1e-3);
            assertTrue(timing.tF3() < moment && timing.tF4() > moment);
        }
    }

    @Test
    void theTurnBackIsHalfOfTheTimeBetween() {
        SpinTiming timing = spin(Timing.EQUAL_READINGS, 0, wallAt(3));
        assertEquals((timing.tF4() - timing.tF3()) / 2, timing.tP(), 1e-12);
    }

    @Test
    void byRangeTheMomentsAreTheFirstSampleWithTheWallAndTheFirstWithoutIt() {
        SpinTiming timing = spin(Timing.RANGE, 0, wallAt(3.04));
        assertEquals(1.1, timing.tF3(), 1e-12, "the wall comes into range at 1.04");
        assertEquals(5.1, timing.tF4(), 1e-12, "and leaves it at 5.04");
        assertEquals(2, timing.tP(), 1e-12);
    }

    @Test
    void byRangeAWallInSightFromTheStartIsNotComeTo() {
        SpinTiming timing = new SpinTiming(Timing.RANGE);
        timing.start(0, TURN);
        timing.approach(0, 0.4, 0);
        timing.approach(0.1, 0.3, 0);
        assertFalse(timing.comesToWall());
    }

    @Test
    void byEqualReadingsAWallInSightFromTheStartIsComeToAsSoonAsReadingsFall() {
        SpinTiming timing = new SpinTiming(Timing.EQUAL_READINGS);
        timing.start(0, TURN);
        timing.approach(0, 0.3, 0);
        timing.approach(0.1, 0.4, 0);
        assertFalse(timing.comesToWall(), "the wall behind goes");
        timing.approach(0.2, 0.38, 0);
        assertTrue(timing.comesToWall());
    }

    @Test
    void ofTwoWallsThatMergeTheFirstIsTimedByItself() {
        DoubleUnaryOperator first = wallAt(3);
        DoubleUnaryOperator second = wallAt(4);
        SpinTiming timing = spin(Timing.EQUAL_READINGS, 0, t -> Math.min(first.applyAsDouble(t), second.applyAsDouble(t)));
        assertEquals(3, (timing.tF3() + timing.tF4()) / 2, 0.05);
    }

    @Test
    void aWiggleOfTheNoiseIsNoWall() {
        SpinTiming timing = new SpinTiming(Timing.EQUAL_READINGS);
        timing.start(0.005, TURN);
        for (int i = 0; i < 50; i++) {
            timing.approach(i * STEP, 0.4 + wiggle(i), 0);
            assertFalse(timing.comesToWall());
        }
    }

    @Test
    void aWallThatTheRobotRollsTowardsIsNotComeTo() {
        SpinTiming timing = new SpinTiming(Timing.EQUAL_READINGS);
        timing.start(0, TURN);
        for (int i = 0; i < 10; i++) {
            timing.approach(i * STEP, 0.4 - 0.002 * i, 0.003);
            assertFalse(timing.comesToWall());
        }
        timing.approach(1, 0.37, 0);
        assertTrue(timing.comesToWall(), "what comes nearer than by the way rolled is another wall");
    }

    @Test
    void noiseIsAveragedAwayWhereManySamplesFitIntoASmallTurn() {
        SpinTiming timing = new SpinTiming(Timing.EQUAL_READINGS);
        timing.start(0.005, Math.toRadians(0.5));
        for (int i = 0; i < 20; i++) {
            timing.approach(i * STEP, 0.4 + wiggle(i), 0);
            assertFalse(timing.comesToWall(), "the swing of 16 mm is gone");
        }
        for (int i = 20; i < 30; i++) {
            timing.approach(i * STEP, 0.392 + wiggle(i), 0);
        }
        assertTrue(timing.comesToWall(), "a fall of 8 mm shows: with ten samples four deviations are 6.3 mm");
    }

    private static double wiggle(int i) {
        return i % 2 == 0 ? 0.008 : -0.008;
    }

    @Test
    void byRangeNothingIsAveraged() {
        SpinTiming timing = new SpinTiming(Timing.RANGE);
        timing.start(0.005, Math.toRadians(0.5));
        timing.approach(0, Reading.NOTHING, 0);
        timing.approach(STEP, 0.7, 0);
        assertTrue(timing.comesToWall());
    }

    @Test
    void aNewSpinForgetsTheOneBefore() {
        SpinTiming timing = spin(Timing.EQUAL_READINGS, 0, wallAt(3));
        timing.start(0, TURN);
        assertTrue(Double.isNaN(timing.tF3()) && Double.isNaN(timing.tF4()));
        timing.approach(7, Reading.NOTHING, 0);
        assertFalse(timing.comesToWall());
    }
}
