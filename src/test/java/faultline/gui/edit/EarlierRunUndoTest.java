package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Edits that are undone after a restart: the run is one of the scenario without them, whatever its timeline does. */
@ExtendWith(EdtChecker.class)
class EarlierRunUndoTest {

    private static final String STAND = "coat-stand";
    private static final Pose EDITED = new Pose(5.4, 4.6, 0);
    private static final Pose PLANNED = new Pose(6.4, 3.6, 0);
    private static final Command EDIT = new Command.MoveObstacle(STAND, EDITED);
    private static final Command PLAN = new Command.MoveObstacle(STAND, PLANNED);
    private static final Obstacle PLACED = new Obstacle("placed", new ObstacleShape.CircleShape(0.1), PLANNED);

    private EditedRun run;
    private Obstacle stand;

    @BeforeEach
    void open() {
        run = new EditedRun();
        stand = run.atStart(STAND).orElseThrow();
    }

    @AfterEach
    void close() {
        run.close();
    }

    private void plan(double seconds, Command command) {
        run.plan(List.of(new TimedCommand(seconds, command)));
    }

    private void assertShown(Obstacle expected) {
        assertEquals(Optional.of(expected), run.shown(expected.id()));
        run.assertSameObstacles();
    }

    @Test
    void theTimelinePlacesAnObstacleAsBeforeTheEdit() {
        plan(0.2, new Command.PlaceObstacle(PLACED));
        run.advanceTo(30);
        run.send(new Command.MoveObstacle("placed", EDITED));
        run.restart();
        run.undo();
        run.advanceTo(30);
        assertShown(PLACED);
        run.redo();
        assertShown(PLACED.withPose(EDITED));
    }

    @Test
    void theTimelineMovesAnObstacleWhoseRemovalIsUndone() {
        plan(0.2, PLAN);
        run.send(new Command.RemoveObstacle(STAND));
        run.restart();
        run.undo();
        run.advanceTo(30);
        assertEquals(Optional.of(stand.withPose(PLANNED)), run.shown(STAND));
    }

    @Test
    void anObstacleReturnsToItsStartBeforeTheTimelineMovesIt() {
        plan(0.2, PLAN);
        run.advanceTo(30);
        run.send(EDIT);
        run.restart();
        run.undo();
        assertShown(stand);
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    /** The timeline returns the obstacle to its first place, so the same command undoes both edits. */
    @Test
    void editsOfTwoRunsFromTheSamePlaceAreUndoneOneByOne() {
        plan(0.2, new Command.MoveObstacle(STAND, stand.pose()));
        run.advanceTo(10);
        run.send(EDIT);
        run.restart();
        run.advanceTo(30);
        run.send(PLAN);
        run.restart();
        for (int i = 0; i < 2; i++) {
            assertEquals(Optional.of(stand.withPose(PLANNED)), run.atStart(STAND));
            run.undo();
            assertEquals(Optional.of(stand.withPose(EDITED)), run.atStart(STAND));
            run.undo();
            assertEquals(Optional.of(stand), run.atStart(STAND));
            run.redo();
            run.redo();
        }
    }

    @Test
    void anEditThatWasUndoneBeforeTheRestartIsRedone() {
        plan(0.2, PLAN);
        run.send(EDIT);
        run.undo();
        run.restart();
        run.advanceTo(30);
        run.redo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand.withPose(EDITED)), run.atStart(STAND));
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    /** The edit was made at the planned place, and redone at that of the start. */
    @Test
    void anEditThatWasRedoneEarlierIsUndoneToItsStart() {
        plan(0.1, PLAN);
        run.advanceTo(20);
        run.send(new Command.PlaceObstacle(new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), PLANNED)));
        run.seek(2);
        run.redo();
        run.restart();
        run.undo();
        assertShown(stand);
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    @Test
    void anEditOfThisRunIsUndoneTogetherWithOneOfTheRunBefore() {
        Scenario first = run.scenario();
        run.send(EDIT);
        run.restart();
        run.advanceTo(10);
        run.send(new Command.MoveObstacle(STAND, PLANNED));
        runOnEdt(() -> {
            run.edits().undo();
            run.edits().undo();
        });
        run.rest();
        assertEquals(first, run.scenario());
        assertShown(stand);
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        run.redo();
        run.redo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.empty(), callOnEdt(run.edits()::redoName));
    }

    /** The command that redoes the second edit is the same as the one that undoes the first. */
    @Test
    void anObstacleThatWasMovedToThePlaceBeforeReturnsToItsStart() {
        plan(0.2, PLAN);
        run.advanceTo(30);
        run.send(EDIT);
        run.restart();
        run.send(PLAN);
        run.restart();
        run.undo();
        run.undo();
        assertShown(stand);
        assertEquals(Optional.of(stand), run.atStart(STAND));
        run.redo();
        run.redo();
        assertShown(stand.withPose(PLANNED));
    }

    /** An edit that is ahead of the run is not done again after the start has changed. */
    @Test
    void anEditAheadMustBeRedoneManually() {
        run.send(EDIT);
        run.restart();
        run.advanceTo(20);
        run.send(new Command.MoveObstacle(STAND, PLANNED));
        run.seek(10);
        run.undo();
        assertShown(stand);
        run.advanceTo(30);
        assertShown(stand);
        run.redo();
        assertShown(stand.withPose(EDITED));
        run.redo();
        assertEquals(Optional.of(stand.withPose(PLANNED)), run.shown(STAND));
    }

    /** Deletion makes the edit of the sensor part of the scenario, where it is undone by the next command. */
    @Test
    void anEditOfASensorThatWasDeletedAndRestoredRemainsUndone() {
        Scenario first = run.scenario();
        run.send(EDIT);
        run.restart();
        run.send(new Command.ConfigureSensor(
                first.setup().robot().sensor("left").orElseThrow().withRange(0.5)));
        run.removeSensor("left");
        for (int i = 0; i < 3; i++) {
            run.undo();
        }
        assertEquals(first, run.scenario());
    }

    /** The sensor front is deleted, and left is called front before both have their own ids again. */
    @Test
    void editsAreUndoneAfterASensorHadTheIdOfADeletedOne() {
        RobotSpec robot = run.scenario().setup().robot();
        SensorSpec front = robot.sensor("front").orElseThrow();
        plan(0.05, new Command.ConfigureSensor(front.withNoise(0.1)));
        Scenario first = run.scenario();
        run.advanceTo(10);
        for (String id : List.of("front", "left")) {
            run.send(new Command.ConfigureSensor(robot.sensor(id).orElseThrow().withRange(0.5)));
        }
        run.send(new Command.ConfigureController(WallFollowing.DEFAULT.withDistance(0.4)));
        run.restart();
        Scenario edited = run.scenario();
        run.removeSensor("front");
        run.renameSensor("left", "front");
        for (int i = 0; i < 5; i++) {
            run.undo();
        }
        assertEquals(first, run.scenario());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        for (int i = 0; i < 3; i++) {
            run.redo();
        }
        assertEquals(edited, run.scenario());
    }

    /** Redo is an edit of the setup, so the run keeps its tick. */
    @Test
    void theRunStaysAtItsTick() {
        run.send(EDIT);
        run.restart();
        run.advanceTo(20);
        run.undo();
        assertEquals(20, run.tick());
        run.redo();
        assertEquals(20, run.tick());
    }

    @Test
    void anEditOfTheRunBeforeIsUndoneAsTheTimelineSays() {
        plan(0.2, PLAN);
        run.advanceTo(15);
        run.send(EDIT);
        run.restart();
        run.advanceTo(10);
        run.undo();
        assertShown(stand);
        run.redo();
        assertShown(stand.withPose(EDITED));
        run.advanceTo(30);
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    /** A restart that is cancelled leaves the run with the edit at its tick. */
    @Test
    void anEditIsUndoneInTheRunAfterACancelledRestart() {
        plan(0.2, PLAN);
        run.advanceTo(30);
        run.send(EDIT);
        runOnEdt(() -> {
            run.controller().moveStart(start -> start);
            run.workspace().cancelTask();
        });
        run.rest();
        run.advanceTo(40);
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    /** The timeline puts the obstacle where the edit has moved it. */
    @Test
    void anObstacleThatTheTimelineHasPlacedBeforeTheEditReturns() {
        plan(0.05, new Command.PlaceObstacle(PLACED));
        run.advanceTo(10);
        run.send(new Command.MoveObstacle("placed", EDITED));
        run.restart();
        run.advanceTo(30);
        assertEquals(Optional.of(PLACED.withPose(EDITED)), run.shown("placed"));
        run.undo();
        assertEquals(Optional.of(PLACED), run.shown("placed"));
        run.assertSameObstacles();
    }
}
