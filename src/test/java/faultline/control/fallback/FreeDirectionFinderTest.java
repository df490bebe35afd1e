package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.DeadReckoning;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FreeDirectionFinderTest {

    private static final RobotSpec BLIND =
            RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6)).withSensors(List.of());
    private static final double LENGTH = 0.3;
    private static final double DISTANCE = 0.2;

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private final DeadReckoning at = diagnosis.reckoning();
    private final LocalMap map = new LocalMap();
    private final FreeDirectionFinder directionFinder = new FreeDirectionFinder(map);

    FreeDirectionFinderTest() {
        diagnosis.update(new Observation(0, 0.01, BLIND, new double[0]), 0, 0, 1);
        refresh(0.1);
    }

    private void refresh(double known) {
        map.refresh(diagnosis, 1000, known);
    }

    /** Marks a wall through a point at some distance from the robot, perpendicular to a direction. */
    private void wall(double degrees, double distance) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        for (double along = -0.8; along <= 0.8; along += 0.005) {
            double x = distance * cos - along * sin;
            double y = distance * sin + along * cos;
            if (Math.abs(x) < 0.85 && Math.abs(y) < 0.85) {
                diagnosis.markUnseen(x, y);
            }
        }
        refresh(0.1);
    }

    private double degrees(double from, double length, double distance) {
        assertTrue(directionFinder.find(at, Math.toRadians(from), length, PathClearance.around(distance)));
        return Math.toDegrees(directionFinder.direction());
    }

    @Test
    void withoutSurfacesTheFirstDirectionIsFree() {
        assertEquals(90, degrees(90, LENGTH, DISTANCE), 1e-9);
        assertEquals(-30, degrees(-30, LENGTH, DISTANCE), 1e-9);
    }

    @ParameterizedTest
    @CsvSource({"0", "90", "180", "-90"})
    void besideAWallTheRobotDrivesAlongIt(double side) {
        wall(side, 0.22);
        // 0.22 m - 0.3 m * cos(a) is at least 0.2 m for a of about 86 degrees and more.
        assertEquals(side - 85, degrees(side, LENGTH, DISTANCE), 6);
    }

    @Test
    void aSmallerDistanceIsKeptFromTheSurfacesOnTheRight() {
        wall(90, 0.5);
        wall(-90, 0.3);
        directionFinder.begin(StrictMath.PI);
        assertFalse(find(0.45, 0.45), "the passage is too narrow");
        assertTrue(find(0.45, 0.25));
        assertEquals(0, Math.toDegrees(directionFinder.direction()), 12);
        directionFinder.begin(StrictMath.PI);
        assertFalse(find(0.45, 0.37), "the wall on the right is too near");
        wall(0, 0.6);
        assertFalse(find(0.45, 0.25), "the passage ends");
    }

    @Test
    void aDirectionThatContinuesTheLastOneMayBeSlightlyNearerToSurfacesOnTheRight() {
        wall(90, 0.5);
        wall(-90, 0.3);
        for (double last : new double[] {-20, 0, 20}) {
            directionFinder.begin(Math.toRadians(last));
            assertTrue(find(0.45, 0.37), "after " + last);
        }
        for (double last : new double[] {-55, 55, 180}) {
            directionFinder.begin(Math.toRadians(last));
            assertFalse(find(0.45, 0.37), "after " + last);
        }
        directionFinder.begin(0);
        assertFalse(find(0.45, 0.43), "the wall on the right is too near");
    }

    private boolean find(double distance, double onRight) {
        return directionFinder.find(at, StrictMath.PI / 2, LENGTH, new PathClearance(distance, onRight, 0.1))
                && Math.cos(directionFinder.direction()) > 0;
    }

    @Test
    void aWallAheadTurnsTheRobotOn() {
        wall(90, 0.22);
        wall(0, 0.3);
        // 0.3 m - 0.3 m * cos(a) is at least 0.2 m for a of about -70 degrees and less.
        assertEquals(-70, degrees(90, LENGTH, DISTANCE), 6);
        assertEquals(45, degrees(90, 0.1, 0.15), 6);
    }

    @Test
    void theMiddleOfThePathMustBeFreeToo() {
        // The end, 0.6 m ahead, is farther than 0.2 m from a post 0.3 m ahead; the middle is at it.
        diagnosis.markUnseen(0.3, 0);
        refresh(0.1);
        double turned = degrees(0, 0.6, DISTANCE);
        assertTrue(turned <= -30 && turned >= -45, "turned to " + turned);
    }

    @Test
    void noDirectionIsFreeInAnEnclosure() {
        for (int side = 0; side < 360; side += 90) {
            wall(side, 0.3);
        }
        assertFalse(directionFinder.find(at, 0, LENGTH, PathClearance.around(DISTANCE)));
    }

    @Test
    void theDirectionsCoverAlmostAFullTurn() {
        // Only directions from about 25 to 45 degrees are free.
        for (int degrees = 68; degrees <= 362; degrees += 3) {
            double a = Math.toRadians(degrees);
            diagnosis.markUnseen(0.45 * Math.cos(a), 0.45 * Math.sin(a));
        }
        refresh(0.1);
        assertEquals(45 - 360, degrees(10, LENGTH, DISTANCE), 1e-9, "the last one: 325 degrees clockwise");
        assertFalse(directionFinder.find(at, Math.toRadians(15), LENGTH, PathClearance.around(DISTANCE)));
        assertEquals(45 - 360, Math.toDegrees(directionFinder.direction()), 1e-9, "the last one remains");
    }

    @ParameterizedTest
    @CsvSource({"0", "90", "135", "-60"})
    void theRobotCanRollUpToTheFirstUnknownPlace(double direction) {
        refresh(0.4);
        double radians = Math.toRadians(direction);
        double known = directionFinder.known(at, radians, 1, 0.1, 0.08);
        // The corners of the front leave the disc of 0.4 m first: 0.39 m ahead.
        assertEquals(0.39 - 0.125 - 0.015, known, 0.04);
        double ahead = directionFinder.unknownX() * Math.cos(radians) + directionFinder.unknownY() * Math.sin(radians);
        double across =
                -directionFinder.unknownX() * Math.sin(radians) + directionFinder.unknownY() * Math.cos(radians);
        assertEquals(known + 0.03 + 0.125, ahead, 1e-9);
        assertEquals(0.08, Math.abs(across), 0.08 + 1e-9);
    }

    @Test
    void allThreeLinesOfTheStripAreTested() {
        for (int side = -1; side <= 1; side++) {
            SensorDiagnosis fresh = new SensorDiagnosis(WallSide.LEFT);
            fresh.update(new Observation(0, 0.01, BLIND, new double[0]), 0, 0, 1);
            for (double x = 0.21; x < 0.3; x += 0.02) {
                fresh.markUnseen(x, side * 0.08);
            }
            LocalMap around = new LocalMap();
            around.refresh(fresh, 1000, 0.5);
            FreeDirectionFinder strip = new FreeDirectionFinder(around);
            double known = strip.known(fresh.reckoning(), 0, 0.3, 0.1, 0.08);
            assertEquals(0.06, known, 1e-9, "line " + side);
            assertEquals(0.215, strip.unknownX(), 1e-9);
            assertEquals(side * 0.08, strip.unknownY(), 1e-9);
        }
    }

    @Test
    void theLimitIsReturnedIfAllIsKnown() {
        refresh(0.8);
        assertEquals(0.3, directionFinder.known(at, 0, 0.3, 0.1, 0.08));
    }
}
