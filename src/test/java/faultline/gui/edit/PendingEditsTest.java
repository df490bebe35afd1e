package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PendingEditsTest {

    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0));

    private final PendingEdits pending = new PendingEdits();

    @Test
    void pendingCommandsAreAppliedInTheirOrder() {
        SensorSpec left = RobotSpec.DEFAULT.sensor("left").orElseThrow();
        pending.add(List.of(new Command.SetPlatform(0.3, 0.2, 0.4)));
        pending.add(List.of(new Command.ConfigureSensor(left.withRange(1.5))));
        pending.add(List.of(new Command.SwitchSensor("left", false), new Command.SwitchSensor("nose", false)));
        assertEquals(
                RobotSpec.DEFAULT
                        .withPlatform(0.3, 0.2, 0.4)
                        .withSensor(left.withRange(1.5).withOn(false)),
                pending.robot());
    }

    @Test
    void aCommandIsPendingUntilTheFirstFrameAfterItsAnswer() {
        Runnable onAnswered = pending.add(List.of(new Command.SwitchSensor("left", false)));
        pending.setRobot(RobotSpec.DEFAULT);
        assertFalse(isLeftOn(), "not answered");
        onAnswered.run();
        assertFalse(isLeftOn(), "no frame since the answer");
        pending.setRobot(RobotSpec.DEFAULT);
        assertTrue(isLeftOn(), "the frame shows that the command was refused");
    }

    @Test
    void whatTheNewestFrameShowsIsExpected() {
        RobotSpec longer = RobotSpec.DEFAULT.withPlatform(0.4, 0.2, 0.3);
        pending.setRobot(longer);
        assertEquals(longer, pending.robot());
        ControllerSpec drive = new ControllerSpec.Drive(1, 2);
        pending.setController(drive);
        assertEquals(drive, pending.controller());
    }

    @Test
    void anObstacleThatIsBeingRemovedIsNotExpected() {
        assertEquals(List.of(BOX), pending.expected(List.of(BOX)));
        Obstacle moved = BOX.withPose(new Pose(2, 1, 0));
        pending.add(List.of(new Command.RemoveObstacle("pole"), new Command.MoveObstacle("box", moved.pose())));
        assertEquals(List.of(moved), pending.expected(List.of(BOX)));
        pending.add(List.of(new Command.RemoveObstacle("box")));
        assertEquals(List.of(), pending.expected(List.of(BOX)));
        pending.add(List.of(new Command.PlaceObstacle(BOX)));
        assertEquals(List.of(BOX), pending.expected(List.of(BOX)), "placed again");
    }

    @Test
    void aMoveDoesNotBringARemovedObstacleBack() {
        pending.add(List.of(new Command.RemoveObstacle("box")));
        pending.add(List.of(new Command.MoveObstacle("box", new Pose(2, 1, 0))));
        assertEquals(List.of(), pending.expected(List.of(BOX)));
    }

    /** As when many obstacles are selected and moved by a key. */
    @Test
    void manyObstaclesWithAPendingCommandEachAreExpectedAtOnce() {
        Pose moved = new Pose(2, 1, 0);
        List<Obstacle> boxes =
                IntStream.range(0, 40_000).mapToObj(i -> BOX.withId("box" + i)).toList();
        pending.add(boxes.stream()
                .<Command>map(box -> new Command.MoveObstacle(box.id(), moved))
                .toList());
        List<Obstacle> expected = assertTimeout(Duration.ofSeconds(8), () -> pending.expected(boxes));
        assertEquals(boxes.stream().map(box -> box.withPose(moved)).toList(), expected);
    }

    private boolean isLeftOn() {
        return pending.robot().sensor("left").orElseThrow().on();
    }

    @Test
    void anObstacleIsExpectedAtTheLastPoseThatWasSent() {
        pending.add(List.of(new Command.MoveObstacle("box", new Pose(2, 1, 0))));
        pending.add(List.of(new Command.MoveObstacle("pole", new Pose(4, 1, 0))));
        pending.add(List.of(new Command.MoveObstacle("box", new Pose(3, 1, 0))));
        assertEquals(new Pose(3, 1, 0), pending.expected(BOX).pose());
        pending.clear();
        assertEquals(BOX, pending.expected(BOX));
    }

    @Test
    void anObstacleIsExpectedWithTheShapeThatWasSentAndThePoseSentAfterIt() {
        Obstacle larger = BOX.withShape(new ObstacleShape.CircleShape(0.2));
        pending.add(List.of(new Command.PlaceObstacle(larger)));
        pending.add(List.of(new Command.PlaceObstacle(BOX.withId("pole"))));
        pending.add(List.of(new Command.MoveObstacle("box", new Pose(2, 1, 0))));
        assertEquals(larger.withPose(new Pose(2, 1, 0)), pending.expected(BOX));
    }
}
