package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class WallTrackerTest {

    private static final double STEP = 0.003;
    private static final double RADIUS = 0.35;

    private final WallTracker tracker = new WallTracker();

    @BeforeEach
    void startAt25Centimetres() {
        tracker.start(0.25);
    }

    @Test
    void itStartsParallelAtTheReading() {
        assertEquals(0.25, tracker.distance());
        assertEquals(0, tracker.heading());
        assertEquals(0, tracker.innovation());
    }

    @Test
    void tenCentimetresAt30DegreesToTheWallAreFiveNearer() {
        tracker.predict(0, Math.PI / 6, 0);
        tracker.predict(0.1, 0, 0);
        assertEquals(0.2, tracker.distance(), 1e-12);
        assertEquals(Math.PI / 6, tracker.heading(), 1e-12);
    }

    @Test
    void roundACornerOnItsCircleTheHeadingStaysAlongIt() {
        tracker.predict(RADIUS, 1, 1 / RADIUS);
        assertEquals(0, tracker.heading(), 1e-12);
        assertEquals(0.25, tracker.distance(), 1e-12);
    }

    @Test
    void readingsAsPredictedTeachNothing() {
        tracker.predict(STEP, 0, 0);
        tracker.correct(0.25, STEP, RADIUS);
        assertEquals(0, tracker.innovation());
        assertEquals(0, tracker.heading());
    }

    /** A count of all innovations would overflow on a long path around a disc. */
    @Test
    void theLastSixteenInnovationsAreKept() {
        for (int i = 1; i <= 40; i++) {
            tracker.predict(0, 0, 0);
            // A robot at rest: the filter corrects nothing.
            tracker.correct(0.25 + 0.001 * i, 0, RADIUS);
        }
        assertEquals(16, tracker.innovationCount());
        // The mean of 25 to 40, and of the last two, millimetres.
        assertEquals(0.0325, tracker.meanInnovation(16), 1e-12);
        assertEquals(0.0395, tracker.meanInnovation(2), 1e-12);
    }

    @Test
    void theInnovationBeforeThatIsKept() {
        tracker.predict(STEP, 0, 0);
        tracker.correct(0.252, STEP, RADIUS);
        assertEquals(0, tracker.previousInnovation());
        tracker.predict(STEP, 0, 0);
        assertEquals(0.002, tracker.previousInnovation(), 1e-12);
        tracker.turnHeading(0.1);
        assertEquals(0, tracker.previousInnovation());
    }

    @Test
    void aWallThatComesNearerBy1In10IsHeadedFor() {
        for (int i = 1; i <= 100; i++) {
            tracker.predict(STEP, 0, 0);
            tracker.correct(0.25 - 0.1 * STEP * i, STEP, RADIUS);
        }
        assertEquals(Math.asin(0.1), tracker.heading(), 0.001);
        assertEquals(0.22, tracker.distance(), 0.0002);
    }

    @Test
    void aReadingFartherThanPredictedIsAPositiveInnovation() {
        tracker.predict(STEP, 0, 0);
        tracker.correct(0.26, STEP, RADIUS);
        assertEquals(0.01, tracker.innovation(), 1e-12);
        assertTrue(tracker.distance() > 0.25 && tracker.distance() < 0.26, "it is believed in part");
        assertTrue(tracker.heading() < 0, "the robot heads away from the wall");
    }

    @Test
    void anOutlierIsTakenAtItsDistanceAndTeachesNoHeading() {
        tracker.predict(STEP, 0, 0);
        tracker.correct(0.4, STEP, RADIUS);
        assertEquals(0.4, tracker.distance());
        assertEquals(0, tracker.heading());
        assertEquals(0, tracker.innovation());
    }

    @Test
    void standingStillTeachesNoHeading() {
        tracker.predict(0, 0, 0);
        tracker.correct(0.26, 0, RADIUS);
        assertEquals(0, tracker.heading());
    }

    @Test
    void aReadingThatGrowsAsAtACornerGivesTheInnovationOfACornerInTheEnd() {
        for (int i = 1; i <= 1000; i++) {
            double way = i * 0.0002;
            tracker.predict(0.0002, 0, 0);
            tracker.correct(0.25 + way * way / (2 * RADIUS), 0.0002, RADIUS);
        }
        assertEquals(WallTracker.cornerInnovation(RADIUS), tracker.innovation(), 0.1 * tracker.innovation());
    }

    @Test
    void turningTheHeadingClearsTheInnovations() {
        tracker.correct(0.26, 0, RADIUS);
        tracker.turnHeading(-0.1);
        assertEquals(-0.1, tracker.heading(), 1e-12);
        assertEquals(0, tracker.innovation());
    }

    @Test
    void theDriftIsAllOfAnInnovationThatLasts() {
        double way = 0;
        while (way < 2) {
            way += STEP;
            tracker.predict(STEP, 0, 0);
            tracker.correct(tracker.distance() - 0.002, STEP, RADIUS);
        }
        assertEquals(-0.002, tracker.drift(), 1e-5);
        tracker.turnHeading(0);
        assertEquals(0, tracker.drift());
    }

    @Test
    void aWayOfAQuarterOfAMillimetreLeaves2Point5PercentOfTheNoiseInTheDrift() {
        assertEquals(0.025, WallTracker.driftNoiseShare(0.00025), 1e-9);
    }

    /** The filter averages over 3 cm here; steps beyond that must not make it oscillate. */
    @Test
    void stepsLongerThanItsMemoryAreStable() {
        for (int i = 1; i <= 40; i++) {
            tracker.predict(0.08, 0, 0);
            tracker.correct(10 - 0.008 * i, 0.08, RADIUS);
        }
        assertEquals(Math.asin(0.1), tracker.heading(), 1e-4);
        assertEquals(9.68, tracker.distance(), 1e-4);
    }

    @Test
    void anArcIsRolledAtItsMiddleHeading() {
        tracker.predict(0.1, 0.2, 0);
        assertEquals(0.2, tracker.heading(), 1e-12);
        assertEquals(0.25 - 0.1 * Math.sin(0.1), tracker.distance(), 1e-12);
    }

    @Test
    void drivingBackwardsIsTrackedAsFarAsDrivingAheadButTeachesNoHeading() {
        WallTracker ahead = new WallTracker();
        ahead.start(0.25);
        for (int i = 1; i <= 10; i++) {
            ahead.predict(STEP, 0, 0);
            ahead.correctDistance(0.25 + 0.002 * i, STEP, RADIUS);
            tracker.predict(-STEP, 0, 0);
            tracker.correct(0.25 + 0.002 * i, -STEP, RADIUS);
        }
        assertEquals(ahead.distance(), tracker.distance());
        assertEquals(ahead.drift(), tracker.drift());
        assertEquals(0, tracker.heading());
        assertEquals(10 * STEP, tracker.distanceSinceReset(), 1e-12);
        assertEquals(WallTracker.driftNoiseShare(STEP), WallTracker.driftNoiseShare(-STEP));
    }

    @Test
    void backwardsTheRobotLeavesTheWallThatItHeadsFor() {
        tracker.predict(0, Math.PI / 6, 0);
        tracker.predict(-0.1, 0, 0);
        assertEquals(0.3, tracker.distance(), 1e-12);
    }

    @Test
    void aMuchNearerReadingIsAnOutlierToo() {
        tracker.predict(STEP, 0, 0);
        assertEquals(0, tracker.correctDistance(0.1, STEP, RADIUS));
        assertEquals(0.1, tracker.distance());
        assertEquals(0, tracker.innovationCount());
    }

    @Test
    void aNewStartForgetsWhatTheTrackerHasLearnt() {
        tracker.predict(STEP, 0, 0);
        tracker.correct(0.26, STEP, RADIUS);
        tracker.turnHeading(0.1);
        tracker.predict(STEP, 0, 0);
        tracker.correct(0.26, STEP, RADIUS);
        assertTrue(tracker.switched());
        tracker.start(0.3);
        assertFalse(tracker.switched());
        assertEquals(0.3, tracker.distance());
        assertEquals(0, tracker.heading());
        assertEquals(0, tracker.innovation());
        assertEquals(0, tracker.innovationCount());
        assertEquals(0, tracker.drift());
        assertEquals(0, tracker.distanceSinceReset());
    }

    @Test
    void withoutAReadingThereIsNoInnovation() {
        tracker.correct(0.26, STEP, RADIUS);
        tracker.predict(STEP, 0, 0);
        assertEquals(0, tracker.innovation());
    }
}
