package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.control.WallSide;
import faultline.control.wallfollower.SensorViews.Direction;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SensorViewsTest {

    private static SensorSpec sensor(String id, double bearingDegrees) {
        return new SensorSpec(id, Vector2.ZERO, Math.toRadians(bearingDegrees), 0.8, 0.3, true, 0);
    }

    private static RobotSpec robot(SensorSpec... sensors) {
        return new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of(sensors));
    }

    private static SensorView facing(
            Direction direction, RobotSpec robot, Map<String, Double> readings, WallSide side) {
        SensorViews views = new SensorViews(side);
        views.update(Observations.observation(0, robot, readings));
        return views.facing(direction);
    }

    /** The sensor of a robot that looks to the left. */
    private static SensorView left(RobotSpec robot, Map<String, Double> readings) {
        return facing(Direction.LEFT, robot, readings, WallSide.LEFT);
    }

    @Test
    void aSensorIsFoundByItsBearingWithAnyName() {
        RobotSpec robot = robot(sensor("left", 0), sensor("elephant", 90));
        Map<String, Double> readings = Map.of("left", 0.1, "elephant", 0.2);
        assertEquals(
                0.1, facing(Direction.FRONT, robot, readings, WallSide.LEFT).reading());
        assertEquals(0.2, left(robot, readings).reading());
    }

    @ParameterizedTest
    @CsvSource({"270, LEFT, RIGHT, -90", "270, RIGHT, LEFT, 90", "-270, LEFT, LEFT, 90", "315, LEFT, FRONT_RIGHT, -45"})
    void aBearingMayBeGivenTheOtherWayRound(int degrees, WallSide side, Direction direction, int bearing) {
        SensorView view = facing(direction, robot(sensor("round", degrees)), Map.of("round", 0.2), side);
        assertEquals(0.2, view.reading());
        assertEquals(Math.toRadians(bearing), view.bearing(), 1e-12);
    }

    @Test
    void ofTwoSensorsTheOneThatLooksMoreInTheDirectionServes() {
        RobotSpec robot = robot(sensor("rough", 82), sensor("good", 93));
        assertEquals(0.2, left(robot, Map.of("rough", 0.1, "good", 0.2)).reading());
    }

    @Test
    void aSensorThatIsOffLeavesItsPlaceToTheNextBest() {
        RobotSpec robot = robot(sensor("rough", 82), sensor("good", 93));
        assertEquals(0.1, left(robot, Map.of("rough", 0.1, "good", Reading.OFF)).reading());
    }

    @Test
    void aSensorThatLooksElsewhereDoesNotServe() {
        assertFalse(left(robot(sensor("aside", 67)), Map.of("aside", 0.1)).present());
    }

    @Test
    void theDirectionsAreThoseOfTheStandardSensorsInTheirMirrorImageWithTheWallOnTheRight() {
        Map<String, Double> readings =
                Map.of("front", 0.1, "front-left", 0.2, "left", 0.3, "front-right", 0.4, "right", 0.5);
        assertEquals(List.of(0.3, 0.1, 0.2, 0.4, 0.5), all(readings, WallSide.LEFT));
        assertEquals(List.of(0.5, 0.1, 0.4, 0.2, 0.3), all(readings, WallSide.RIGHT));
    }

    private static List<Double> all(Map<String, Double> readings, WallSide side) {
        return Arrays.stream(Direction.values())
                .map(direction ->
                        facing(direction, RobotSpec.DEFAULT, readings, side).reading())
                .toList();
    }

    @Test
    void ofTwoSensorsWithTheSameBearingTheFirstServes() {
        RobotSpec robot = robot(sensor("first", 90), sensor("second", 90));
        assertEquals(0.1, left(robot, Map.of("first", 0.1, "second", 0.2)).reading());
    }

    @Test
    void otherSensorsServeAsSoonAsTheRobotHasThem() {
        SensorViews views = new SensorViews(WallSide.LEFT);
        views.update(Observations.observation(0, robot(sensor("one", 90)), Map.of("one", 0.1)));
        views.update(Observations.observation(1, robot(sensor("other", 45)), Map.of("other", 0.2)));
        assertFalse(views.facing(Direction.LEFT).present());
        assertEquals(0.2, views.facing(Direction.FRONT_LEFT).reading());
    }
}
