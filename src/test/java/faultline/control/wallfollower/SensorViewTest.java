package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.WallSide;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SensorViewTest {

    private static final double EXACT = 1e-12;
    private static final double QUARTER_TURN = Math.PI / 2;

    private static SensorView view(Vector2 mountPosition, double bearing, double halfConeDegrees, double reading) {
        return new SensorView(mountPosition, bearing, Math.toRadians(halfConeDegrees), 0.8, reading, true);
    }

    @Test
    void aWallAcrossTheAxisIsAsFarFromTheCentreAsMountAndReadingTogether() {
        assertEquals(0.35, view(new Vector2(0, 0.1), QUARTER_TURN, 10, 0.25).perpendicularDistance(), EXACT);
    }

    @Test
    void aWallWhoseFootLiesInTheConeIsAsFarAsTheReading() {
        assertEquals(0.25, view(Vector2.ZERO, 0, 10, 0.25).wallDistance(Math.toRadians(9)), EXACT);
    }

    @Test
    void aWallWhoseFootLiesOutsideIsReadOnTheConesEdge() {
        assertEquals(0.5, view(Vector2.ZERO, 0, 10, 1).wallDistance(Math.toRadians(70)), EXACT);
        assertEquals(0.5, view(Vector2.ZERO, 0, 10, 1).wallDistance(Math.toRadians(-70)), EXACT);
    }

    @Test
    void aMountCountsByHowFarItLiesTowardsTheWall() {
        assertEquals(1.1, view(new Vector2(0.2, 7), 0, 89, 1).wallDistance(0) - 0.1, EXACT);
        assertEquals(8, view(new Vector2(0.2, 7), QUARTER_TURN, 89, 1).wallDistance(QUARTER_TURN), EXACT);
    }

    @Test
    void whereNothingIsSeenAWallIsBeyondTheRange() {
        SensorView blank = view(Vector2.ZERO, 0, 10, Reading.NOTHING);
        assertFalse(blank.detects());
        assertEquals(0.8, blank.minDistance());
        assertEquals(0.8, blank.perpendicularDistance(), EXACT);
        assertFalse(blank.detectsWithin(100), "that something might be there is not to see it");
    }

    @Test
    void itDetectsWithinTheSumOfMountAndReading() {
        SensorView eye = view(new Vector2(0.5, 0), 0, 10, 0.25);
        assertTrue(eye.detectsWithin(0.75));
        assertFalse(eye.detectsWithin(0.74));
    }

    @Test
    void anAbsentSensorDetectsNothingAtAnyDistance() {
        assertFalse(SensorView.NONE.detects());
        assertFalse(SensorView.NONE.present());
        assertFalse(SensorView.NONE.detectsWithin(100));
    }

    private static SensorSpec sensor(String id, double bearingDegrees) {
        return new SensorSpec(id, Vector2.ZERO, Math.toRadians(bearingDegrees), 0.8, 0.3, true, 0);
    }

    private static RobotSpec robot(SensorSpec... sensors) {
        return new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of(sensors));
    }

    /** The sensor of a robot that looks to the left. */
    private static SensorView left(RobotSpec robot, Map<String, Double> readings) {
        return SensorView.facing(QUARTER_TURN, Observations.observation(0, robot, readings), WallSide.LEFT);
    }

    @Test
    void aSensorIsFoundByItsBearingWithAnyName() {
        RobotSpec robot = robot(sensor("left", 0), sensor("elephant", 90));
        Map<String, Double> readings = Map.of("left", 0.1, "elephant", 0.2);
        assertEquals(
                0.1,
                SensorView.facing(0, Observations.observation(0, robot, readings), WallSide.LEFT)
                        .reading());
        assertEquals(0.2, left(robot, readings).reading());
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
    void anotherReadingChangesNothingElse() {
        SensorView view = view(new Vector2(0, 0.1), QUARTER_TURN, 10, 0.25);
        assertEquals(view(new Vector2(0, 0.1), QUARTER_TURN, 10, 0.5), view.withReading(0.5));
    }
}
