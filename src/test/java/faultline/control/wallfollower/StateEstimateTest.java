package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.control.Odometer;
import faultline.control.WallSide;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

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

    @Test
    void theDistanceFromTheCentreIsThatOfTheMountAndTheReadingButNotWithinTheBody() {
        StateEstimate estimate = estimate(ALL_DIRECTIONS, WallSide.LEFT);
        assertEquals(0.35, estimate.centreDistance(0.25), 1e-12);
        assertEquals(0.1, estimate.centreDistance(-0.05), 1e-12);
    }
}
