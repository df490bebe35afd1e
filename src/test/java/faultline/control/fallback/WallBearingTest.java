package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.robot.RobotSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

class WallBearingTest {

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private final LocalMap map = new LocalMap();
    private final WallBearing wall = new WallBearing(map);

    WallBearingTest() {
        diagnosis.update(new Observation(0, 0.01, RobotSpec.DEFAULT.withSensors(List.of()), new double[0]), 0, 0, 1);
        map.refresh(diagnosis, 1000, 0.1);
    }

    /** Marks a surface half a metre from the robot, in the middle of a cell as far as possible. */
    private void mark(double degrees) {
        diagnosis.markUnseen(0.5 * Math.cos(Math.toRadians(degrees)), 0.5 * Math.sin(Math.toRadians(degrees)));
        map.refresh(diagnosis, 1000, 0.1);
    }

    private void assertDegrees(double expected) {
        assertEquals(expected, Math.toDegrees(wall.direction()), 2);
    }

    @Test
    void aWallIsLostAfterOneMetreAndTwentyWithoutIt() {
        wall.begin(0, true);
        wall.advance(-0.3);
        wall.advance(0.3);
        assertFalse(wall.isLost(), "the start counts as half of it");
        wall.advance(0.001);
        assertTrue(wall.isLost());
        mark(10);
        wall.follow(0.6);
        wall.advance(1.2);
        assertFalse(wall.isLost());
        wall.advance(0.001);
        assertTrue(wall.isLost());
    }

    @Test
    void awayFromAWallItIsLostFromTheStart() {
        wall.begin(0, false);
        assertTrue(wall.isLost());
    }

    @Test
    void itFollowsTheNearestSurfaceWithin75DegreesWithoutJumpsOfAFullTurn() {
        wall.begin(Math.toRadians(710), true);
        mark(60);
        wall.follow(0.6);
        assertDegrees(780);
        wall.begin(Math.toRadians(-20), true);
        wall.follow(0.6);
        assertDegrees(-20);
        wall.begin(Math.toRadians(50), true);
        wall.follow(0.4);
        assertDegrees(50);
    }

    @Test
    void aLostOneIsFoundInAnyDirection() {
        wall.begin(0, false);
        wall.find(0, 0.6);
        assertTrue(wall.isLost(), "there is none");
        mark(-150);
        wall.find(0, 0.6);
        assertFalse(wall.isLost());
        assertDegrees(-150);
    }

    @Test
    void anotherWallReplacesItButItIsNotSeenBefore() {
        wall.begin(0, false);
        mark(120);
        wall.replace(Math.toRadians(30), 0.6);
        assertDegrees(0);
        wall.replace(Math.toRadians(50), 0.6);
        assertDegrees(120);
        assertTrue(wall.isLost());
    }
}
