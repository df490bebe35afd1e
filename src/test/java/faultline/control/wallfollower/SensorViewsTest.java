package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.control.WallSide;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SensorViewsTest {

    private static final Map<String, Double> ALL_DIRECTIONS =
            Map.of("front", 0.1, "front-left", 0.2, "left", 0.3, "front-right", 0.4, "right", 0.5);

    private static SensorSpec sensor(String id, double bearingDegrees) {
        return new SensorSpec(id, Vector2.ZERO, Math.toRadians(bearingDegrees), 0.8, 0.3, true, 0);
    }

    private static RobotSpec robot(SensorSpec... sensors) {
        return new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of(sensors));
    }

    @Test
    void everyDirectionHasItsSensor() {
        SensorViews views = SensorViews.of(Observations.observation(0, ALL_DIRECTIONS), WallSide.LEFT);
        assertEquals(List.of(0.3, 0.1, 0.2, 0.4, 0.5), readings(views));
    }

    @Test
    void withTheWallOnTheRightLeftAndRightChangePlaces() {
        SensorViews views = SensorViews.of(Observations.observation(0, ALL_DIRECTIONS), WallSide.RIGHT);
        assertEquals(List.of(0.5, 0.1, 0.4, 0.2, 0.3), readings(views));
        assertEquals(new Vector2(0, 0.1), views.left().mountPosition(), "in the mirror it sits on the left");
        assertEquals(Math.PI / 2, views.left().bearing(), 1e-12, "in the mirror it looks to the left");
    }

    private static List<Double> readings(SensorViews views) {
        return List.of(
                views.left().reading(),
                views.front().reading(),
                views.frontLeft().reading(),
                views.frontRight().reading(),
                views.right().reading());
    }

    @Test
    void aSensorIsFoundByItsBearingWithAnyName() {
        RobotSpec robot = robot(sensor("left", 0), sensor("elephant", 90));
        SensorViews views =
                SensorViews.of(Observations.observation(0, robot, Map.of("left", 0.1, "elephant", 0.2)), WallSide.LEFT);
        assertEquals(0.1, views.front().reading());
        assertEquals(0.2, views.left().reading());
    }

    @Test
    void ofTwoSensorsTheOneThatLooksMoreInTheDirectionServes() {
        RobotSpec robot = robot(sensor("rough", 82), sensor("good", 93));
        assertEquals(
                0.2,
                SensorViews.of(Observations.observation(0, robot, Map.of("rough", 0.1, "good", 0.2)), WallSide.LEFT)
                        .left()
                        .reading());
    }

    @Test
    void aSensorThatIsOffLeavesItsPlaceToTheNextBest() {
        RobotSpec robot = robot(sensor("rough", 82), sensor("good", 93));
        assertEquals(
                0.1,
                SensorViews.of(
                                Observations.observation(0, robot, Map.of("rough", 0.1, "good", Reading.OFF)),
                                WallSide.LEFT)
                        .left()
                        .reading());
    }

    @Test
    void aSensorThatLooksElsewhereDoesNotServe() {
        RobotSpec robot = robot(sensor("aside", 67));
        assertFalse(SensorViews.of(Observations.observation(0, robot, Map.of("aside", 0.1)), WallSide.LEFT)
                .left()
                .present());
    }

    @Test
    void withoutSensorsNothingIsPresent() {
        SensorViews views = SensorViews.of(Observations.observation(0, robot(), Map.of()), WallSide.LEFT);
        assertEquals(
                new SensorViews(SensorView.NONE, SensorView.NONE, SensorView.NONE, SensorView.NONE, SensorView.NONE),
                views);
    }

    @Test
    void anotherFrontSensorChangesNothingElse() {
        SensorViews views = SensorViews.of(Observations.observation(0, ALL_DIRECTIONS), WallSide.LEFT)
                .withFront(SensorView.NONE);
        assertEquals(List.of(0.3, Reading.NOTHING, 0.2, 0.4, 0.5), readings(views));
    }
}
