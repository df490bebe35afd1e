package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** An obstacle that is moved against a robot that has not left its start stays there. */
@ExtendWith(EdtChecker.class)
class StoppedAtStartTest {

    private static final String BOX = "box";

    private final EditedRun run = new EditedRun();

    @AfterEach
    void close() {
        run.close();
    }

    private Pose atStart() {
        return run.atStart(BOX).orElseThrow().pose();
    }

    private static void assertNear(Pose expected, Pose actual) {
        assertEquals(0, actual.position().distanceTo(expected.position()), 1.1e-6);
    }

    @Test
    void aRestartLeavesItWhereItStopped() {
        run.send(new Command.ConfigureController(new ControllerSpec.None()));
        run.advance(10);
        Pose robot = SessionFrames.frame(run.workspace()).snapshot().pose();
        assertEquals(run.scenario().setup().start(), robot);
        Vector2 ahead = robot.position().plus(Vector2.direction(robot.heading()).times(0.525));
        Obstacle box = new Obstacle(BOX, new ObstacleShape.RectangleShape(0.2, 0.2), robot.withPosition(ahead));
        run.send(new Command.PlaceObstacle(box));
        run.send(new Command.MoveObstacle(BOX, robot));
        Pose stopped = run.shown(BOX).orElseThrow().pose();
        assertEquals(0.225, stopped.position().distanceTo(robot.position()), 1e-6);
        assertNear(stopped, atStart());
        run.undo();
        assertEquals(box.pose(), atStart());
        run.redo();
        run.restart();
        assertNear(stopped, run.shown(BOX).orElseThrow().pose());
        assertNotEquals(stopped, atStart(), "a file with a robot that touches something is not valid");
        run.undo();
        assertEquals(box.pose(), atStart());
        run.redo();
        assertNear(stopped, atStart());
    }
}
