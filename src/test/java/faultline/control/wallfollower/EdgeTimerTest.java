package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.TimingRule;
import faultline.sensor.Reading;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Spins past walls that are given as readings over time, sampled every 0.1 s from 0. */
class EdgeTimerTest {

    private static final double STEP = 0.1;
    private static final int MAX_SAMPLES = 200;

    /** Of the robot in a step: too much for two samples to be averaged. */
    private static final double TURN = Math.toRadians(3);

    private static EdgeTimer timeSpin(TimingRule rule, double noise, DoubleUnaryOperator readings) {
        EdgeTimer timing = EdgeTimer.of(rule);
        timing.start(0.08, noise, true, TURN);
        int i = 0;
        do {
            timing.addApproachSample(i * STEP, readings.applyAsDouble(i * STEP), 0);
        } while (!timing.reachesWall() && ++i < MAX_SAMPLES);
        do {
            i++;
            timing.addPassSample(i * STEP, readings.applyAsDouble(i * STEP));
        } while (!timing.leavesWall() && i < MAX_SAMPLES);
        assertTrue(i < MAX_SAMPLES, "the wall was not timed");
        return timing;
    }

    /**
     * A wall that is nearest, 0.25 m, at a moment, and farther by 0.1 m for every second before and after; seen up to
     * 0.45 m.
     */
    private static DoubleUnaryOperator wallAt(double moment) {
        return t -> {
            double reading = 0.25 + 0.1 * Math.abs(t - moment);
            return reading <= 0.45 ? reading : Reading.NOTHING;
        };
    }

    @Test
    void beforeASpinNoMomentIsKnown() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        assertTrue(Double.isNaN(timing.tF3()) && Double.isNaN(timing.tF4()) && Double.isNaN(timing.tP()));
    }

    @Test
    void equalReadingsLieEvenlyOnEitherSideOfTheNearestEvenBetweenSamples() {
        for (double moment : new double[] {3, 3.02, 3.05, 3.09}) {
            EdgeTimer timing = timeSpin(TimingRule.EQUAL_READINGS, 0, wallAt(moment));
            assertEquals(moment, (timing.tF3() + timing.tF4()) / 2, 1e-3);
            assertTrue(timing.tF3() < moment && timing.tF4() > moment);
        }
    }

    @Test
    void theTurnBackIsHalfOfTheTimeBetween() {
        EdgeTimer timing = timeSpin(TimingRule.EQUAL_READINGS, 0, wallAt(3));
        assertEquals((timing.tF4() - timing.tF3()) / 2, timing.tP(), 1e-12);
    }

    @Test
    void byRangeTheMomentsAreTheFirstSampleWithTheWallAndTheFirstWithoutIt() {
        EdgeTimer timing = timeSpin(TimingRule.RANGE, 0, wallAt(3.04));
        assertEquals(1.1, timing.tF3(), 1e-12, "the wall comes into range at 1.04");
        assertEquals(5.1, timing.tF4(), 1e-12, "and leaves it at 5.04");
        assertEquals(2, timing.tP(), 1e-12);
    }

    @Test
    void byRangeAWallInSightFromTheStartIsNotReached() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.RANGE);
        timing.start(0.08, 0, true, TURN);
        timing.addApproachSample(0, 0.4, 0);
        timing.addApproachSample(0.1, 0.3, 0);
        assertFalse(timing.reachesWall());
    }

    @Test
    void byEqualReadingsAWallInSightFromTheStartIsReachedAsSoonAsReadingsFall() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.08, 0, true, TURN);
        timing.addApproachSample(0, 0.3, 0);
        timing.addApproachSample(0.1, 0.4, 0);
        assertFalse(timing.reachesWall(), "the wall behind goes");
        timing.addApproachSample(0.2, 0.38, 0);
        assertTrue(timing.reachesWall());
    }

    @Test
    void ofTwoWallsThatMergeTheFirstIsTimedByItself() {
        DoubleUnaryOperator first = wallAt(3);
        DoubleUnaryOperator second = wallAt(4);
        EdgeTimer timing =
                timeSpin(TimingRule.EQUAL_READINGS, 0, t -> Math.min(first.applyAsDouble(t), second.applyAsDouble(t)));
        assertEquals(3, (timing.tF3() + timing.tF4()) / 2, 0.05);
    }

    @Test
    void aWiggleOfTheNoiseIsNoWall() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.08, 0.005, true, TURN);
        for (int i = 0; i < 50; i++) {
            timing.addApproachSample(i * STEP, 0.4 + wiggle(i), 0);
            assertFalse(timing.reachesWall());
        }
    }

    @Test
    void aWallThatTheRobotRollsTowardsIsNotReached() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.08, 0, true, TURN);
        for (int i = 0; i < 10; i++) {
            timing.addApproachSample(i * STEP, 0.4 - 0.002 * i, 0.003);
            assertFalse(timing.reachesWall());
        }
        timing.addApproachSample(1, 0.37, 0);
        assertTrue(timing.reachesWall(), "what comes nearer than by the way rolled is another wall");
    }

    @Test
    void noiseIsAveragedAwayWhereManySamplesFitIntoASmallTurn() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.08, 0.005, true, Math.toRadians(0.5));
        for (int i = 0; i < 20; i++) {
            timing.addApproachSample(i * STEP, 0.4 + wiggle(i), 0);
            assertFalse(timing.reachesWall(), "the swing of 16 mm is gone");
        }
        for (int i = 20; i < 30; i++) {
            timing.addApproachSample(i * STEP, 0.392 + wiggle(i), 0);
        }
        assertTrue(timing.reachesWall(), "a fall of 8 mm shows: with ten samples four deviations are 6.3 mm");
    }

    @Test
    void readingsThatFallAndRiseWhileTheClockRunsBackwardsGiveANegativeTurnBack() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.08, 0, true, TURN);
        timing.addApproachSample(0, 0.4, 0);
        timing.addApproachSample(-0.2, 0.3, 0);
        assertTrue(timing.reachesWall());
        timing.addPassSample(-0.4, 0.4);
        assertTrue(timing.leavesWall());
        // The level of 0.324 m is passed 0.152 s after the first sample and 0.048 s after the second.
        assertEquals(-0.152, timing.tF3(), 1e-12);
        assertEquals(-0.248, timing.tF4(), 1e-12);
        assertEquals(-0.048, timing.tP(), 1e-12);
    }

    private static double wiggle(int i) {
        return i % 2 == 0 ? 0.008 : -0.008;
    }

    @Test
    void byRangeNothingIsAveraged() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.RANGE);
        timing.start(0.08, 0.005, true, Math.toRadians(0.5));
        timing.addApproachSample(0, Reading.NOTHING, 0);
        timing.addApproachSample(STEP, 0.7, 0);
        assertTrue(timing.reachesWall());
    }

    @Test
    void aNewSpinForgetsTheOneBefore() {
        EdgeTimer timing = timeSpin(TimingRule.EQUAL_READINGS, 0, wallAt(3));
        timing.start(0.08, 0, true, TURN);
        assertTrue(Double.isNaN(timing.tF3()) && Double.isNaN(timing.tF4()));
        timing.addApproachSample(7, Reading.NOTHING, 0);
        assertFalse(timing.reachesWall());
    }

    @Test
    void aRobotThatStillRollsBackwardsSeesNoFallInASteadyReading() {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.15, 0, true, 0.01);
        for (int i = 0; i < 6; i++) {
            timing.addApproachSample(i * STEP, 0.5, 0.0005 * i - 0.003);
            assertFalse(timing.reachesWall(), "sample " + i);
        }
    }

    /** Five deviations count as an extreme, and both sides of the wall must be as clear three times over. */
    @Test
    void ofNoisyReadingsThoseAreTimedThatAreClearlyFartherThanTheNearest() {
        EdgeTimer timing = timeSpin(TimingRule.EQUAL_READINGS, 0.005, wallAt(3));
        assertEquals(3, (timing.tF3() + timing.tF4()) / 2, 1e-3);
        assertEquals(0.75, timing.tP(), 1e-3, "the wall is 75 mm farther than the nearest after 0.75 s");
    }

    @Test
    void aWallThatIsAlmostNearestAtTheStartIsTimedByTheReadingAtTheStart() {
        EdgeTimer timing = timeSpin(TimingRule.EQUAL_READINGS, 0, wallAt(0.1));
        assertEquals(0, timing.tF3(), 1e-3);
        assertEquals(0.2, timing.tF4(), 1e-3, "as far as at the start");
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRiseAndAFallAreAnotherWallOnlyIfTheNoiseIsKnown(boolean known) {
        EdgeTimer timing = EdgeTimer.of(TimingRule.EQUAL_READINGS);
        timing.start(0.08, 0, known, TURN);
        timing.addApproachSample(0, 0.4, 0);
        timing.addApproachSample(0.1, 0.3, 0);
        assertTrue(timing.reachesWall());
        timing.addPassSample(0.2, 0.31);
        assertFalse(timing.leavesWall());
        timing.addPassSample(0.3, 0.305);
        assertEquals(known, timing.leavesWall());
    }
}
