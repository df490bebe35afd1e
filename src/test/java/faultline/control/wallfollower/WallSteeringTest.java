package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.GainRule;
import faultline.sensor.Reading;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Steering at a wanted reading of 0.25 m; the robot's centre is 0.1 m farther off. */
class WallSteeringTest {

    private static final double WANTED = 0.25;

    private final StateEstimate estimate = Observations.stateEstimate(WANTED);
    private final WallSteering steering = new WallSteering(estimate, WANTED, GainRule.AUTOMATIC);
    private long tick;

    /** A tick of rolling straight on at 0.3 m/s, after which the left sensor reads this. */
    private void roll(double left) {
        estimate.odometer().command(0.3, 0);
        estimate.update(Observations.observation(++tick, Map.of("left", left)));
    }

    @Test
    void beforeTheFirstDecisionThereAreNoTerms() {
        assertTrue(Double.isNaN(steering.proportional()) && Double.isNaN(steering.derivative()));
    }

    @Test
    void atTheWantedDistanceItGoesStraight() {
        steering.begin();
        assertEquals(0, steering.wallTurnRate());
    }

    @Test
    void aroundACornerItKeepsToTheCircleAboutIt() {
        steering.begin();
        assertEquals(0.3 / 0.35, steering.cornerTurnRate(), 1e-12, "speed over radius");
    }

    @Test
    void tooNearItTurnsAway() {
        roll(0.2);
        steering.begin();
        assertTrue(steering.wallTurnRate() < 0);
        assertEquals(steering.wallTurnRate(), steering.proportional() + steering.derivative(), 1e-12);
    }

    @Test
    void aWallIsLostWhenNothingOrSomethingElseIsSeen() {
        steering.begin();
        assertTrue(steering.isWallInSight());
        roll(Reading.NOTHING);
        assertFalse(steering.isWallInSight());
        roll(0.7);
        assertFalse(steering.isWallInSight());
        roll(0.24);
        assertTrue(steering.isWallInSight());
    }

    @Test
    void aStraightWallNeverBends() {
        steering.begin();
        for (int i = 0; i < 100; i++) {
            roll(WANTED);
            steering.trackWall();
            assertFalse(steering.bendsAway() || steering.bendsBack());
        }
    }

    @Test
    void noiseOfTenMinutesAlongAStraightWallIsNeverTakenForABend() {
        SplittableRandom random = new SplittableRandom(5);
        steering.begin();
        for (int i = 0; i < 60_000; i++) {
            roll(WANTED + 0.001 * random.nextGaussian());
            steering.trackWall();
            assertFalse(steering.bendsAway(), "reading " + i);
        }
    }

    @Test
    void rollingStraightPastACornerItIsSeenToBendAwayWithinSixCentimetres() {
        steering.begin();
        double way = 0;
        while (!steering.bendsAway() && way < 1) {
            way += 0.003;
            roll(Math.hypot(0.35, way) - 0.1);
            steering.trackWall();
        }
        assertTrue(way < 0.06, "seen after " + way + " m");
    }

    @Test
    void roundACornerReadingsThatFallBelowTheCirclesSayThatAWallFollows() {
        steering.begin();
        steering.switchToCorner();
        double way = 0;
        while (!steering.bendsBack() && way < 1) {
            way += 0.003;
            estimate.odometer().command(0.3, 0.3 / 0.35);
            estimate.update(Observations.observation(++tick, Map.of("left", 0.25 - way * way / 0.7)));
            steering.trackCorner();
        }
        assertTrue(way < 0.08, "seen after " + way + " m");
    }

    @Test
    void aStraightWallThatIsRoundedForACornerShowsInTimeThroughNoise() {
        SplittableRandom random = new SplittableRandom(3);
        steering.begin();
        for (int i = 0; i < 100; i++) {
            roll(WANTED + 0.002 * random.nextGaussian());
            steering.trackWall();
        }
        steering.switchToCorner();
        double way = 0;
        while (!steering.bendsBack() && way < 3) {
            way += 0.003;
            roll(WANTED + 0.002 * random.nextGaussian());
            steering.trackCorner();
        }
        assertTrue(way < 0.4, "seen after " + way + " m");
    }
}
