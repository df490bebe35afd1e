package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.robot.MotorFaults;
import faultline.robot.WheelSpeeds;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import java.util.List;
import org.junit.jupiter.api.Test;

class ViewportTest {

    private final Viewport viewport = new Viewport();

    ViewportTest() {
        viewport.resize(800, 600);
        viewport.setWorld(robotAt(1, 1));
    }

    @Test
    void theFirstWorldIsFitted() {
        assertEquals(3, camera().x());
        assertEquals(2, camera().y());
        assertEquals(752 / 6.0, camera().scale());
    }

    @Test
    void aFittedWorldStaysFittedWhenTheCanvasIsResized() {
        viewport.resize(440, 600);
        assertEquals(392 / 6.0, camera().scale());
    }

    @Test
    void aLayoutThatKeepsTheSizeOfTheCanvasKeepsTheView() {
        Obstacle outside = new Obstacle("outside", new ObstacleShape.CircleShape(1), new Pose(8, 2, 0));
        viewport.setWorld(SampleFrames.frameOf(new Pose(1, 1, 0), outside).snapshot());
        viewport.resize(800, 600);
        assertEquals(752 / 6.0, camera().scale());
        viewport.fit();
        assertEquals(752 / 9.0, camera().scale());
    }

    @Test
    void aZoomedViewKeepsItsScaleWhenTheCanvasIsResized() {
        viewport.zoom(2);
        viewport.resize(440, 600);
        assertEquals(2 * 752 / 6.0, camera().scale());
    }

    @Test
    void furtherFramesLeaveTheViewUnchanged() {
        viewport.zoom(2);
        Camera before = camera();
        viewport.setWorld(robotAt(5, 3));
        assertEquals(before, camera());
    }

    @Test
    void theFirstWorldOfAnotherScenarioIsFittedAlsoIfItHasTheSizeOfTheLast() {
        Camera fitted = camera();
        viewport.moveCamera(camera -> camera.panned(500, 0));
        viewport.startScenario();
        viewport.setWorld(robotAt(5, 3));
        assertEquals(fitted, camera());
        viewport.moveCamera(camera -> camera.panned(500, 0));
        viewport.setWorld(robotAt(5, 2));
        assertNotEquals(fitted, camera());
    }

    @Test
    void aWorldOfAnotherSizeIsFittedAgain() {
        viewport.zoom(2);
        Snapshot old = robotAt(1, 1);
        viewport.setWorld(new Snapshot(
                0,
                0,
                12,
                4,
                true,
                old.robot(),
                old.pose(),
                new WheelSpeeds(0, 0),
                MotorFaults.NONE,
                List.of(),
                List.of(),
                List.of(),
                List.of()));
        assertEquals(752 / 12.0, camera().scale());
    }

    @Test
    void followingKeepsTheRobotInTheMiddlePart() {
        viewport.zoom(4);
        viewport.setFollowing(true);
        for (double x = 1; x < 5; x += 0.05) {
            viewport.setWorld(robotAt(x, 1));
            Vector2 robot = camera().toScreen(new Vector2(x, 1));
            assertTrue(
                    Math.abs(robot.x() - 400) <= 161 && Math.abs(robot.y() - 300) <= 121, "the robot is at " + robot);
        }
    }

    @Test
    void followingBringsTheRobotToTheCentre() {
        viewport.zoom(4);
        viewport.setFollowing(true);
        Vector2 robot = camera().toScreen(new Vector2(1, 1));
        assertEquals(400, robot.x(), 0.5);
        assertEquals(300, robot.y(), 0.5);
    }

    @Test
    void afterZoomingAFollowedRobotIsStillInTheMiddlePart() {
        viewport.setFollowing(true);
        viewport.zoomAbout(new Vector2(0, 0), 8);
        Vector2 robot = camera().toScreen(new Vector2(1, 1));
        assertTrue(Math.abs(robot.x() - 400) <= 161 && Math.abs(robot.y() - 300) <= 121, "the robot is at " + robot);
        viewport.setFollowing(false);
        viewport.zoomAbout(new Vector2(0, 0), 2);
        assertNotEquals(robot, camera().toScreen(new Vector2(1, 1)));
    }

    @Test
    void followingLeavesTheViewUnchangedWhileTheRobotIsInTheMiddlePart() {
        viewport.zoom(4);
        viewport.setFollowing(true);
        viewport.setWorld(robotAt(1, 1));
        Camera settled = camera();
        viewport.setWorld(robotAt(1.05, 1));
        assertEquals(settled, camera());
        viewport.setWorld(robotAt(3, 1));
        assertNotEquals(settled, camera());
    }

    private Camera camera() {
        return viewport.camera().get();
    }

    private static Snapshot robotAt(double x, double y) {
        return SampleFrames.frameOf(new Pose(x, y, 0)).snapshot();
    }
}
