package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** An obstacle that is moved against the robot stays where it stopped, in the run and in the scenario. */
@ExtendWith(EdtChecker.class)
class SlidObstacleTest {

    private static final String BOX = "box";

    private final EditedRun run = new EditedRun();
    private Pose robot;
    private Obstacle box;

    /** Puts a box ahead of the robot, 0.3 m before its front, and moves it onto the robot's centre. */
    @BeforeEach
    void moveOntoTheRobot() {
        run.advanceTo(10);
        robot = SessionFrames.frame(run.workspace()).snapshot().pose();
        Vector2 ahead = robot.position().plus(Vector2.direction(robot.heading()).times(0.525));
        box = new Obstacle(BOX, new ObstacleShape.RectangleShape(0.2, 0.2), robot.withPosition(ahead));
        run.send(new Command.PlaceObstacle(box));
        run.advanceTo(20);
        robot = SessionFrames.frame(run.workspace()).snapshot().pose();
        run.send(new Command.MoveObstacle(BOX, robot));
    }

    @AfterEach
    void close() {
        run.close();
    }

    private Pose shown() {
        return run.shown(BOX).orElseThrow().pose();
    }

    private void assertAtStart(Pose pose) {
        assertEquals(pose, run.atStart(BOX).orElseThrow().pose());
    }

    @Test
    void theScenarioHasThePlaceWhereItStopped() {
        Pose stopped = shown();
        assertNotEquals(robot, stopped);
        assertEquals(0.225, stopped.position().distanceTo(robot.position()), 1e-6);
        assertAtStart(stopped);
        run.undo();
        assertEquals(box.pose(), shown());
        assertAtStart(box.pose());
        run.redo();
        assertEquals(stopped, shown());
        assertAtStart(stopped);
    }

    @Test
    void aRestartLeavesItWhereItStopped() {
        Pose stopped = shown();
        run.restart();
        assertEquals(stopped, shown());
        run.undo();
        assertAtStart(box.pose());
        run.redo();
        assertAtStart(stopped);
    }

    @Test
    void aChangeOfItsIdLeavesItWhereItStopped() {
        Pose stopped = shown();
        run.rename(BOX, "crate");
        assertEquals(stopped, run.atStart("crate").orElseThrow().pose());
    }

    @Test
    void theJournalReplaysTheCollisionToTheBit() {
        run.advance(5);
        Scenario replay =
                callOnEdt(run.workspace()::replayScenario).orElseThrow().join();
        RunResult result = HeadlessRun.run(replay.setup(), ControllerMode.DIRECT, List.of());
        assertEquals(BOX, result.collision().orElseThrow().obstacle());
        assertEquals(SessionFrames.trajectoryHash(run.workspace()), result.trajectoryHash());
    }

    @Test
    void theEventLogNamesThePlaceWhereItStopped() {
        Command moved = new Command.MoveObstacle(BOX, shown());
        EventLog log = SessionFrames.frame(run.workspace()).recording().events();
        List<RunEvent> events = LongStream.range(log.firstIndex(), log.endIndex())
                .mapToObj(log::get)
                .toList();
        assertTrue(
                events.stream()
                        .anyMatch(event -> event instanceof RunEvent.CommandExecuted executed
                                && executed.command().equals(moved)),
                events.toString());
    }
}
