package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A sensor in the robot's middle that looks to the left, with a cone of twice the angle whose sine is 0.6: an object at
 * its edge is 3 parts ahead or behind and 4 aside.
 */
class BlindSpotMemoryTest {

    private static final double QUARTER_TURN = Math.PI / 2;

    private final BlindSpotMemory memory = new BlindSpotMemory();

    private static SensorView view(double reading) {
        return new SensorView(Vector2.ZERO, QUARTER_TURN, Math.asin(0.6), 0.8, reading, true);
    }

    private void detect(double reading, double rolled, double turn) {
        memory.update(view(reading), SensorView.NONE, SensorView.NONE, false, rolled, turn);
    }

    private void loseTarget(double rolled, double turn) {
        detect(Reading.NOTHING, rolled, turn);
    }

    /** Turns by small steps, as dead reckoning does. */
    private void turn(double angle) {
        for (int i = 0; i < 10_000; i++) {
            loseTarget(0, angle / 10_000);
        }
    }

    @Test
    void atFirstThereIsNothing() {
        loseTarget(0.1, 0);
        assertEquals(Reading.NOTHING, memory.distanceAfter(0));
    }

    @Test
    void aRobotThatTurnsLeftLosesWhatIsOnTheLeftToTheFront() {
        detect(0.5, 0, 0.001);
        loseTarget(0.1, 0);
        assertEquals(Math.hypot(0.2, 0.4), memory.distanceAfter(0), 1e-12, "0.3 m ahead when it was lost");
    }

    @Test
    void aWallOnTheLeftDoesNotLeaveTheConeToTheFront() {
        memory.update(view(0.5), SensorView.NONE, SensorView.NONE, true, 0, 0.001);
        loseTarget(0.1, 0);
        assertEquals(Reading.NOTHING, memory.distanceAfter(0));
    }

    @Test
    void aRobotThatDrivesOnLosesItToTheRear() {
        detect(0.5, 0.001, 0);
        loseTarget(0.001, 0);
        assertEquals(Reading.NOTHING, memory.distanceAfter(0), "0.3 m behind when it was lost");
    }

    @Test
    void aTurnToTheLeftBringsItAhead() {
        detect(0.5, 0, 0.001);
        turn(Math.asin(0.8));
        assertEquals(0.4, memory.distanceAfter(0.1), 1e-3, "straight ahead");
    }

    @Test
    void theDistanceThatIsStillToBeRolledCounts() {
        detect(0.5, 0, 0.001);
        assertEquals(Math.hypot(0.1, 0.4), memory.distanceAfter(0.2), 1e-12);
    }

    @Test
    void aNearerObjectReplacesIt() {
        detect(0.5, 0, 0.001);
        detect(0.4, 0, 1e-9);
        assertEquals(0.4, memory.distanceAfter(0), 1e-6);
    }

    @Test
    void whatIsSeenFartherAwayDoesNot() {
        detect(0.4, 0, 0.001);
        detect(0.5, 0, 1e-9);
        assertEquals(0.4, memory.distanceAfter(0), 1e-6);
    }

    @Test
    void aTurnOfMoreThanAQuarterMakesItsPlaceUncertain() {
        detect(0.5, 0, 0.001);
        turn(0.9 * QUARTER_TURN);
        turn(-0.2 * QUARTER_TURN);
        assertEquals(Reading.NOTHING, memory.distanceAfter(0));
    }

    @Test
    void betweenConesThatNearlyMeetThereIsNoBlindSpot() {
        SensorView next =
                new SensorView(Vector2.ZERO, QUARTER_TURN - 2 * Math.asin(0.6), Math.asin(0.6), 0.8, 0.7, true);
        memory.update(view(0.5), SensorView.NONE, next, false, 0, 0.001);
        assertEquals(Reading.NOTHING, memory.distanceAfter(0));
    }

    /**
     * An object ahead is carried out of the cone by a turn of more than 1.6 times the distance, in radians per metre.
     */
    @ParameterizedTest
    @CsvSource({"0.0015, Infinity", "0.0017, 0.5"})
    void onABendItIsLostToTheFrontOnlyIfTheRobotTurnsFaster(double turn, double distance) {
        detect(0.5, 0.001, turn);
        loseTarget(0, 0);
        assertEquals(distance, memory.distanceAfter(0), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({"0, 0.001", "0.001, 0"})
    void whatIsForgottenIsGone(double rolled, double turn) {
        detect(0.5, rolled, turn);
        assertEquals(0.5, memory.distanceAfter(0), 1e-12, "it may be lost to the front or the rear");
        memory.clear();
        assertEquals(Reading.NOTHING, memory.distanceAfter(0));
    }
}
