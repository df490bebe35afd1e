package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.GainRule;
import faultline.control.TimingRule;
import faultline.robot.Velocity;
import faultline.sensor.Reading;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Steering at a wanted reading of 0.25 m; the robot's centre is 0.1 m farther off. */
class WallStatesTest {

    private static final double WANTED = 0.25;

    private final StateEstimate estimate = Observations.stateEstimate(WANTED);
    private final SpinStates spin = new SpinStates(
            estimate, new AlignmentManoeuvre(estimate, TimingRule.EQUAL_READINGS, SpinClock.TURNED_ANGLE));
    private final WallStates wall = new WallStates(estimate, spin, WANTED, GainRule.AUTOMATIC);
    private long tick;

    /** A tick of rolling straight on at 0.3 m/s, after which the left sensor reads this. */
    private void roll(double left) {
        Observations.drive(estimate, new Velocity(0.3, 0));
        estimate.update(Observations.observation(++tick, Map.of("left", left)));
    }

    @Test
    void beforeTheFirstDecisionThereAreNoTerms() {
        assertTrue(Double.isNaN(wall.proportional()) && Double.isNaN(wall.derivative()));
    }

    @Test
    void atTheWantedDistanceItGoesStraight() {
        wall.begin();
        assertEquals(0, wall.correctingTurnRate());
    }

    @Test
    void aroundACornerItKeepsToTheCircleAboutIt() {
        wall.begin();
        assertEquals(0.3 / 0.35, wall.cornerTurnRate(), 1e-12, "speed over radius");
    }

    @Test
    void tooFarItTurnsToTheWallAndTooNearAwayFromItAsMuch() {
        roll(0.26);
        wall.begin();
        double rate = wall.correctingTurnRate();
        assertTrue(rate > 0);
        roll(0.24);
        wall.begin();
        assertEquals(-rate, wall.correctingTurnRate(), 1e-12);
    }

    @Test
    void headingForTheWallItTurnsAway() {
        roll(WANTED);
        wall.begin();
        for (int i = 0; i < 20; i++) {
            Observations.drive(estimate, new Velocity(0, 1));
            estimate.update(Observations.observation(++tick, Map.of("left", WANTED)));
            wall.trackWall();
        }
        assertEquals(wall.correctingTurnRate(), wall.proportional() + wall.derivative(), 1e-12);
        assertTrue(wall.derivative() < 0);
        assertTrue(wall.correctingTurnRate() < 0);
    }

    @Test
    void tooNearItTurnsAway() {
        roll(0.2);
        wall.begin();
        assertTrue(wall.correctingTurnRate() < 0);
        assertEquals(wall.correctingTurnRate(), wall.proportional() + wall.derivative(), 1e-12);
    }

    @Test
    void aWallIsLostWhenNothingOrSomethingElseIsSeen() {
        wall.begin();
        assertTrue(wall.isWallInSight());
        roll(Reading.NOTHING);
        assertFalse(wall.isWallInSight());
        roll(0.7);
        assertFalse(wall.isWallInSight());
        roll(0.24);
        assertTrue(wall.isWallInSight());
    }

    @Test
    void aStraightWallNeverBends() {
        wall.begin();
        for (int i = 0; i < 100; i++) {
            roll(WANTED);
            wall.trackWall();
            assertFalse(wall.isWallEnded() || wall.isWallSeenAgain());
        }
    }

    @Test
    void noiseOfTenMinutesAlongAStraightWallIsNeverTakenForABend() {
        SplittableRandom random = new SplittableRandom(5);
        wall.begin();
        for (int i = 0; i < 60_000; i++) {
            roll(WANTED + 0.001 * random.nextGaussian());
            wall.trackWall();
            assertFalse(wall.isWallEnded(), "reading " + i);
        }
    }

    @Test
    void rollingStraightPastACornerItIsSeenToBendAwayWithinSixCentimetres() {
        wall.begin();
        double way = 0;
        while (!wall.isWallEnded() && way < 1) {
            way += 0.003;
            roll(Math.hypot(0.35, way) - 0.1);
            wall.trackWall();
        }
        assertTrue(way < 0.06 && wall.isWallInSight(), "seen after " + way + " m");
    }

    @Test
    void roundACornerReadingsThatFallBelowTheCirclesSayThatAWallFollows() {
        wall.begin();
        wall.switchToCorner();
        double way = 0;
        while (!wall.isWallSeenAgain() && way < 1) {
            way += 0.003;
            Observations.drive(estimate, new Velocity(0.3, 0.3 / 0.35));
            estimate.update(Observations.observation(++tick, Map.of("left", 0.25 - way * way / 0.7)));
            wall.trackCorner();
        }
        assertTrue(way < 0.08, "seen after " + way + " m");
    }

    @Test
    void aStraightWallThatIsRoundedForACornerShowsInTimeThroughNoise() {
        SplittableRandom random = new SplittableRandom(3);
        wall.begin();
        for (int i = 0; i < 100; i++) {
            roll(WANTED + 0.002 * random.nextGaussian());
            wall.trackWall();
        }
        wall.switchToCorner();
        double way = 0;
        while (!wall.isWallSeenAgain() && way < 3) {
            way += 0.003;
            roll(WANTED + 0.002 * random.nextGaussian());
            wall.trackCorner();
        }
        assertTrue(way < 0.4, "seen after " + way + " m");
    }

    /** Only a slanted approach to a new distance sees the followed wall ahead. */
    @Test
    void whatWasSeenAheadIsRememberedAlongAWall() {
        estimate.update(Observations.observation(++tick, Map.of("left", WANTED, "front", 0.02)));
        wall.begin();
        roll(WANTED);
        wall.trackWall();
        assertTrue(estimate.isFrontTargetWithinTurningCircle());
        wall.configure(WANTED + 0.001, GainRule.AUTOMATIC);
        wall.trackWall();
        assertFalse(estimate.isFrontTargetWithinTurningCircle());
    }

    @Test
    void aCornerThatLeftTheConeCountsAsAheadOnlyOnceTheWallIsLost() {
        wall.begin();
        turnAndSee(Map.of("left", 0.08));
        turnAndSee(Map.of("left", WANTED));
        assertTrue(estimate.isLostWallWithinTurningCircle());
        assertFalse(wall.isWallAhead());
        turnAndSee(Map.of());
        assertTrue(wall.isWallAhead());
    }

    private void turnAndSee(Map<String, Double> readings) {
        Observations.drive(estimate, new Velocity(0, 1));
        estimate.update(Observations.observation(++tick, readings));
    }
}
