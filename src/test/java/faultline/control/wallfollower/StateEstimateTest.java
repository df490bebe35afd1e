package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.control.Odometer;
import faultline.control.Threshold;
import faultline.control.WallSide;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StateEstimateTest {

    private static final Observation ALL_DIRECTIONS = Observations.observation(
            0, Map.of("front", 0.1, "front-left", 0.2, "left", 0.3, "front-right", 0.4, "right", 0.5));

    private static StateEstimate estimate(Observation observation, WallSide side) {
        StateEstimate estimate = new StateEstimate(ControllerSpec.WallFollowing.DEFAULT.withSide(side), new Odometer());
        estimate.update(observation);
        return estimate;
    }

    private static List<Double> readings(StateEstimate estimate) {
        return List.of(
                estimate.left().reading(),
                estimate.frontLeft().reading(),
                estimate.frontRight().reading(),
                estimate.right().reading());
    }

    @Test
    void everyDirectionHasItsSensor() {
        assertEquals(List.of(0.3, 0.2, 0.4, 0.5), readings(estimate(ALL_DIRECTIONS, WallSide.LEFT)));
    }

    @Test
    void withTheWallOnTheRightLeftAndRightChangePlaces() {
        StateEstimate estimate = estimate(ALL_DIRECTIONS, WallSide.RIGHT);
        assertEquals(List.of(0.5, 0.4, 0.2, 0.3), readings(estimate));
        assertEquals(new Vector2(0, 0.1), estimate.left().mountPosition(), "in the mirror it sits on the left");
        assertEquals(Math.PI / 2, estimate.left().bearing(), 1e-12, "in the mirror it looks to the left");
    }

    @Test
    void withoutSensorsNothingIsPresent() {
        RobotSpec blind =
                new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of());
        StateEstimate estimate = estimate(Observations.observation(0, blind, Map.of()), WallSide.LEFT);
        assertEquals(
                List.of(SensorView.NONE, SensorView.NONE, SensorView.NONE, SensorView.NONE),
                List.of(estimate.left(), estimate.frontLeft(), estimate.frontRight(), estimate.right()));
    }

    /** The sensor is a corner of the body, so its distance from the centre is the radius of the robot's circle. */
    @Test
    void whatTheFrontLeftSensorSeesWithinThreeCentimetresIsNear() {
        for (double reading : new double[] {0.001, 0.029, 0.033, 0.2}) {
            Observation observation = Observations.observation(0, Map.of("front-left", reading));
            assertEquals(
                    reading < 0.03,
                    estimate(observation, WallSide.LEFT).isNearSideObjectWithinTurningCircle(),
                    "at " + reading);
        }
    }

    @Test
    void nothingThatWasLostIsNearAtFirst() {
        StateEstimate estimate = estimate(ALL_DIRECTIONS, WallSide.LEFT);
        assertEquals(false, estimate.isLostWallWithinTurningCircle());
    }

    private final Odometer odometer = new Odometer();
    private final StateEstimate turning = new StateEstimate(ControllerSpec.WallFollowing.DEFAULT, odometer);

    /** Processes what the robot sees after a tick in which it turns to the left on the spot. */
    private void turnAndSee(int tick, Map<String, Double> readings) {
        odometer.advance(Observations.LAG_FREE_ROBOT, -6, 6, Observations.DT, 1);
        turning.update(Observations.observation(tick, readings));
    }

    @Test
    void whatATurnCarriesOutOfTheFrontLeftConeIsNearUntilItIsForgotten() {
        turnAndSee(0, Map.of("front-left", 0.02));
        turnAndSee(1, Map.of());
        assertTrue(turning.isNearSideObjectWithinTurningCircle());
        assertFalse(turning.isLostWallWithinTurningCircle());
        turning.clearFrontMemory();
        assertFalse(turning.isNearSideObjectWithinTurningCircle());
    }

    @Test
    void aWallThatATurnCarriesOutOfTheLeftConeIsNearUntilItIsForgotten() {
        turnAndSee(0, Map.of("left", 0.08));
        turnAndSee(1, Map.of());
        assertTrue(turning.isLostWallWithinTurningCircle());
        assertFalse(turning.isNearSideObjectWithinTurningCircle());
        turning.clearFrontMemory();
        assertFalse(turning.isLostWallWithinTurningCircle());
    }

    /** The front left sensor's cone ends at 57.5 degrees, where it sees a wall beside the robot at 0.12 m. */
    private static final double BESIDE = 0.12 / Math.sin(Math.toRadians(57.5));

    @ParameterizedTest
    @CsvSource({"0, false", "0.01, false", "-0.03, true"})
    void aWallBesideTheRobotDoesNotLeaveTheFrontLeftConeTowardsThePath(double farther, boolean isNear) {
        ControllerSpec.WallFollowing near = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.12);
        turning.configure(near);
        turnAndSee(0, Map.of("left", 0.12, "front-left", BESIDE + farther));
        for (int tick = 1; tick < 40; tick++) {
            odometer.advance(Observations.LAG_FREE_ROBOT, 6, 6, Observations.DT, 1);
            turning.update(Observations.observation(tick, Map.of("left", 0.12)));
            if (turning.isNearSideObjectWithinTurningCircle()) {
                assertTrue(isNear, "in tick " + tick);
                return;
            }
        }
        assertFalse(isNear);
    }

    @ParameterizedTest
    @CsvSource({"0.12, 0, false", "0.12, -0.03, true", "0.25, 0, true"})
    void aNearWallThatASpinHasCarriedThroughTheFrontLeftConeIsForgotten(
            double distance, double farther, boolean isRemembered) {
        turning.configure(ControllerSpec.WallFollowing.DEFAULT.withDistance(distance));
        turnAndSee(0, Map.of("front-left", 0.05));
        turnAndSee(1, Map.of("left", 0.12, "front-left", BESIDE + farther));
        turning.forgetWallOfSpin();
        boolean remembered = false;
        for (int tick = 2; tick < 50; tick++) {
            odometer.advance(Observations.LAG_FREE_ROBOT, 6, 6, Observations.DT, 1);
            turning.update(Observations.observation(tick, Map.of("left", 0.12)));
            remembered |= turning.isNearSideObjectWithinTurningCircle();
        }
        assertEquals(isRemembered, remembered);
    }

    @ParameterizedTest
    @CsvSource({"0.05, false", "0.11, false"})
    void whatIsNearerThanTheCornersOrFartherThanTheCircleIsNotInTheWay(double reading, boolean inTheWay) {
        turnAndSee(0, Map.of("left", reading));
        turnAndSee(1, Map.of());
        assertEquals(inTheWay, turning.isLostWallWithinTurningCircle());
    }

    @Test
    void withoutASensorBesideTheWallTheDistanceIsThatOfTheBody() {
        RobotSpec wide =
                new RobotSpec(0.25, 0.30, 0.18, 0.3, 100, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of());
        StateEstimate estimate = estimate(Observations.observation(0, wide, Map.of()), WallSide.LEFT);
        assertEquals(0.4, estimate.centreDistance(0.25), 1e-12);
        assertEquals(2 * wide.motor().maxSpeed() / 0.18, estimate.turnRate(), 1e-12, "the motors are the limit");
    }

    @Test
    void theDistanceFromTheCentreIsThatOfTheMountAndTheReadingButNotWithinTheBody() {
        StateEstimate estimate = estimate(ALL_DIRECTIONS, WallSide.LEFT);
        assertEquals(0.35, estimate.centreDistance(0.25), 1e-12);
        assertEquals(0.1, estimate.centreDistance(-0.05), 1e-12);
    }

    /** The nearest of many readings lies below their mean; 2 mm up and down is noise of more than 2 mm. */
    @ParameterizedTest
    @CsvSource({"0, 0, true", "0.002, 0, false", "0, 0.002, false"})
    void aPointThatIsSeenWithNoiseIsTakenToBeFartherThanTheNearestReading(double front, double left, boolean within) {
        StateEstimate estimate = new StateEstimate(ControllerSpec.WallFollowing.DEFAULT, new Odometer());
        for (int tick = 0; tick < 100; tick++) {
            int sign = tick % 2 == 0 ? 1 : -1;
            estimate.update(Observations.observation(
                    tick, Map.of("front", 0.4 + front * (sign + 1), "left", 0.3 + left * sign)));
            estimate.updateLastSeenPoints();
        }
        Vector2 edge = Vector2.direction(Math.toRadians(10)).times(0.4);
        Vector2 stopped = new Vector2(-estimate.stoppingDistance(), 0);
        double nearest = ROBOT_FRONT.plus(edge).plus(stopped).length();
        assertEquals(within, estimate.isLastSeenPointWithin(nearest + 0.005));
        assertTrue(estimate.isLastSeenPointWithin(nearest + 0.02));
    }

    private static final Vector2 ROBOT_FRONT = Observations.LAG_FREE_ROBOT
            .sensors()
            .get(Observations.LAG_FREE_ROBOT.indexOf("front"))
            .mountPosition();

    /** A robot that still approaches the wall has that wall ahead. */
    @ParameterizedTest
    @CsvSource({
        "0.1, 0.05, true, true",
        "0.1, 0.05, false, false",
        "0.1, -0.05, false, true",
        "-0.1, -0.05, true, false",
        "-0.1, -0.05, false, false",
        "-0.1, -0.15, false, true"
    })
    void aMarginForWallsAheadCountsOnlyAtTheWantedDistance(
            double margin, double beyond, boolean atWantedDistance, boolean ahead) {
        Odometer odometer = new Odometer();
        StateEstimate estimate = new StateEstimate(
                ControllerSpec.WallFollowing.DEFAULT.withThreshold(Threshold.AHEAD_MARGIN, margin), odometer);
        double atMargin = estimateOfDefault().wantedCentreDistance() - ROBOT_FRONT.x();
        estimate.update(Observations.observation(0, Map.of("front", atMargin + beyond)));
        assertEquals(ahead, estimate.isWallAheadWhileFollowing(atWantedDistance));
    }

    private static StateEstimate estimateOfDefault() {
        return estimate(ALL_DIRECTIONS, WallSide.LEFT);
    }
}
