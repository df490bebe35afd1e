package faultline.gui.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.Camera;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ViewpointTest {

    private final Viewpoint viewpoint = new Viewpoint();

    ViewpointTest() {
        viewpoint.resize(800, 600);
        viewpoint.show(robotAt(1, 1));
    }

    @Test
    void theFirstWorldIsFitted() {
        assertEquals(3, camera().x());
        assertEquals(2, camera().y());
        assertEquals(720 / 6.0, camera().scale());
    }

    @Test
    void aFittedWorldStaysFittedWhenTheCanvasIsResized() {
        viewpoint.resize(440, 600);
        assertEquals(360 / 6.0, camera().scale());
    }

    @Test
    void whatAHandHasZoomedKeepsItsScaleWhenTheCanvasIsResized() {
        viewpoint.zoom(2);
        viewpoint.resize(440, 600);
        assertEquals(2 * 720 / 6.0, camera().scale());
    }

    @Test
    void furtherFramesLeaveTheViewAlone() {
        viewpoint.zoom(2);
        Camera before = camera();
        viewpoint.show(robotAt(5, 3));
        assertEquals(before, camera());
    }

    @Test
    void aWorldOfAnotherSizeIsFittedAgain() {
        viewpoint.zoom(2);
        Snapshot old = robotAt(1, 1);
        viewpoint.show(new Snapshot(0, 0, 12, 4, true, old.robot(), old.pose(), 0, 0, List.of(), List.of(), List.of(), Optional.empty()));
        assertEquals(720 / 12.0, camera().scale());
    }

    @Test
    void followingKeepsTheRobotInTheMiddlePart() {
        viewpoint.zoom(4);
        viewpoint.setFollowing(true);
        for (double x = 1; x < 5; x += 0.05) {
            viewpoint.show(robotAt(x, 1));
            Vec robot = camera().toScreen(new Vec(x, 1));
            assertTrue(Math.abs(robot.x() - 400) <= 161 && Math.abs(robot.y() - 300) <= 121, "the robot is at " + robot);
        }
    }

    @Test
    void followingLeavesTheViewAloneWhileTheRobotIsInTheMiddlePart() {
        viewpoint.zoom(4);
        viewpoint.setFollowing(true);
        viewpoint.show(robotAt(1, 1));
        Camera settled = camera();
        viewpoint.show(robotAt(1.05, 1));
        assertEquals(settled, camera());
        viewpoint.show(robotAt(3, 1));
        assertNotEquals(settled, camera());
    }

    private Camera camera() {
        return viewpoint.camera().get();
    }

    private static Snapshot robotAt(double x, double y) {
        return SampleFrames.of(new Pose(x, y, 0)).world();
    }
}
