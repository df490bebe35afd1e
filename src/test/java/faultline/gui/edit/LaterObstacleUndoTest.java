package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Edits of obstacles that are undone after the timeline has changed the same obstacles: the run shows what a run of the
 * edited scenario would show.
 */
@ExtendWith(EdtChecker.class)
class LaterObstacleUndoTest {

    private static final String STAND = "coat-stand";
    private static final Pose EDITED = new Pose(5.4, 4.6, 0);
    private static final Pose PLANNED = new Pose(6.4, 3.6, 0);
    private static final Command EDIT = new Command.MoveObstacle(STAND, EDITED);
    private static final Command PLAN = new Command.MoveObstacle(STAND, PLANNED);

    private EditedRun run;
    private Obstacle stand;

    @BeforeEach
    void open() {
        run = new EditedRun();
        stand = find(run.scenario().setup().world().obstacles(), STAND).orElseThrow();
    }

    @AfterEach
    void close() {
        run.close();
    }

    private static Optional<Obstacle> find(List<Obstacle> obstacles, String id) {
        return obstacles.stream().filter(obstacle -> obstacle.id().equals(id)).findFirst();
    }

    private void plan(TimedCommand... timeline) {
        runOnEdt(() -> run.controller().change(now -> now.withSetup(now.setup().withTimeline(List.of(timeline)))));
        run.rest();
    }

    private static TimedCommand at(double seconds, Command command) {
        return new TimedCommand(seconds, command);
    }

    /** Advances to a tick before the plan, edits, and advances to a tick after it. */
    private void editBeforeThePlan(Command... edit) {
        run.advanceTo(10);
        run.send(edit);
        run.advanceTo(30);
    }

    private Optional<Obstacle> shown(String id) {
        return find(SessionFrames.frame(run.workspace()).snapshot().obstacles(), id);
    }

    private Optional<Obstacle> atStart(String id) {
        return find(run.scenario().setup().world().obstacles(), id);
    }

    private void assertShown(Obstacle expected) {
        assertEquals(Optional.ofNullable(expected), shown(STAND));
        assertSameObstacles();
    }

    /** Checks that a run of the edited scenario has the same obstacles at the present tick. */
    private void assertSameObstacles() {
        try (Session replayed =
                Session.replay(new Journal(run.scenario().setup(), List.of(), 0), run.tick(), tick -> true)) {
            Snapshot expected = replayed.frame().snapshot();
            assertEquals(
                    List.copyOf(expected.obstacles()),
                    SessionFrames.frame(run.workspace()).snapshot().obstacles());
        }
    }

    @Test
    void anObstacleStaysWhereTheTimelineHasMovedIt() {
        plan(at(0.2, PLAN));
        editBeforeThePlan(EDIT);
        for (int i = 0; i < 2; i++) {
            run.undo();
            assertShown(stand.withPose(PLANNED));
            assertEquals(Optional.of(stand), atStart(STAND));
            assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
            run.advance(3);
            run.redo();
            assertShown(stand.withPose(PLANNED));
            assertEquals(Optional.of(stand.withPose(EDITED)), atStart(STAND));
            assertEquals(Optional.of("Move coat-stand"), callOnEdt(run.edits()::undoName));
            run.advance(3);
        }
    }

    /** The edit was made at the planned place, and is redone at the place of the start. */
    @Test
    void anEditThatIsRedoneBeforeTheTimelineIsUndoneToItsStart() {
        plan(at(0.2, PLAN));
        run.advanceTo(30);
        run.send(new Command.PlaceObstacle(new Obstacle(STAND, new ObstacleShape.CircleShape(0.3), PLANNED)));
        run.seek(10);
        run.redo();
        run.advanceTo(28);
        run.undo();
        assertEquals(Optional.of(stand), atStart(STAND));
        assertShown(stand.withPose(PLANNED));
    }

    @Test
    void anEditThatIsRedoneTwiceAfterTheTimelineIsUndoneOnce() {
        plan(at(0.2, PLAN));
        run.send(EDIT);
        run.undo();
        run.advanceTo(60);
        run.redo();
        run.seek(40);
        run.redo();
        run.advanceTo(80);
        run.undo();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        assertEquals(Optional.of(stand), atStart(STAND));
        assertShown(stand.withPose(PLANNED));
    }

    /** Another edit at an earlier tick drops its first execution from the run. */
    @Test
    void anEditThatIsRedoneInAnotherCourseOfTheRunIsUndoneToItsPlaceBefore() {
        plan(at(0.2, PLAN));
        run.advanceTo(60);
        run.send(new Command.PlaceObstacle(new Obstacle(STAND, new ObstacleShape.CircleShape(0.3), PLANNED)));
        run.seek(30);
        run.send(EDIT);
        run.seek(40);
        Pose last = new Pose(5.9, 4.2, 0);
        run.send(new Command.MoveObstacle(STAND, last));
        run.redo();
        run.undo();
        assertEquals(Optional.of(stand.withPose(last)), shown(STAND));
        run.undo();
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), atStart(STAND));
    }

    /** Both obstacles are removed by the same command, and so is what undoes their return. */
    @Test
    void theRemovalsOfTwoObstaclesOfOneIdAreUndoneEach() {
        Command put = new Command.PlaceObstacle(stand.withPose(PLANNED));
        plan(at(0.2, new Command.RemoveObstacle(STAND)), at(0.3, put));
        List<TimedCommand> planned = run.timeline();
        run.send(new Command.RemoveObstacle(STAND));
        run.undo();
        run.advanceTo(40);
        run.send(new Command.RemoveObstacle(STAND));
        run.undo();
        assertEquals(Optional.of(stand), atStart(STAND));
        assertEquals(planned, run.timeline());
        assertShown(stand.withPose(PLANNED));
    }

    @Test
    void anObstacleThatTheTimelineHasNotMovedYetReturns() {
        plan(at(0.2, PLAN));
        run.advanceTo(10);
        run.send(EDIT);
        run.advanceTo(15);
        run.undo();
        assertShown(stand);
        run.advanceTo(30);
        assertShown(stand.withPose(PLANNED));
        run.redo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand.withPose(EDITED)), atStart(STAND));
    }

    @Test
    void anEditAfterTheTimelineIsUndoneInTheRun() {
        plan(at(0.2, PLAN));
        run.advanceTo(30);
        run.send(EDIT);
        run.advanceTo(40);
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), atStart(STAND));
    }

    @Test
    void theRunIsWhatItWasWhereverItIsMoved() {
        plan(at(0.2, PLAN));
        editBeforeThePlan(EDIT);
        run.undo();
        run.advanceTo(40);
        run.seek(15);
        assertEquals(Optional.of(stand.withPose(EDITED)), shown(STAND));
        assertEquals(Optional.of("Move coat-stand"), callOnEdt(run.edits()::undoName));
        run.advanceTo(45);
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of("Move coat-stand"), callOnEdt(run.edits()::redoName));
        run.restart();
        assertShown(stand);
    }

    /** Only the scenario changes, so the run still follows its later commands. */
    @Test
    void laterEditsAreKeptAndRedone() {
        plan(at(0.2, PLAN));
        editBeforeThePlan(EDIT);
        run.advanceTo(40);
        Pose elsewhere = new Pose(3.3, 4.4, 0);
        run.send(new Command.MoveObstacle("chair-1", elsewhere));
        run.seek(35);
        run.undo();
        assertEquals(Optional.of(stand), atStart(STAND));
        run.advanceTo(50);
        assertShown(stand.withPose(PLANNED));
        assertEquals(elsewhere, shown("chair-1").orElseThrow().pose());
        run.seek(32);
        run.advanceTo(50);
        assertShown(stand.withPose(PLANNED));
    }

    @Test
    void theSizeReturnsWhereTheTimelineHasMovedTheObstacle() {
        Obstacle larger = new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), stand.pose());
        plan(at(0.2, PLAN));
        editBeforeThePlan(new Command.PlaceObstacle(larger));
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), atStart(STAND));
        run.redo();
        assertShown(larger.withPose(PLANNED));
        assertEquals(Optional.of(larger), atStart(STAND));
        run.undo();
        assertShown(stand.withPose(PLANNED));
        run.seek(25);
        run.advanceTo(35);
        assertShown(stand.withPose(PLANNED));
    }

    @Test
    void aRemovedObstacleReturnsWhereTheTimelineWouldHaveMovedIt() {
        plan(at(0.2, PLAN));
        editBeforeThePlan(new Command.RemoveObstacle(STAND));
        run.undo();
        assertEquals(Optional.of(stand.withPose(PLANNED)), shown(STAND));
        assertEquals(Optional.of(stand), atStart(STAND));
        assertEquals(List.of(at(0.2, PLAN)), run.timeline());
        run.redo();
        assertShown(null);
    }

    @Test
    void anObstacleThatTheTimelineHasRemovedIsRestoredInTheScenario() {
        plan(at(0.2, new Command.RemoveObstacle(STAND)));
        editBeforeThePlan(EDIT);
        run.undo();
        assertShown(null);
        assertEquals(Optional.of(stand), atStart(STAND));
    }

    @Test
    void anObstacleThatTheTimelineHasReplacedIsRestoredInTheScenario() {
        Obstacle other = new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), PLANNED);
        plan(at(0.2, new Command.PlaceObstacle(other)));
        editBeforeThePlan(EDIT);
        run.undo();
        assertShown(other);
        assertEquals(Optional.of(stand), atStart(STAND));
    }

    /** What the timeline has placed since has the same id, but is another obstacle. */
    @Test
    void anEditIsRedoneForTheObstacleThatTheTimelineHasReplaced() {
        Obstacle other = new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), PLANNED);
        plan(at(0.2, new Command.PlaceObstacle(other)));
        run.advanceTo(10);
        run.send(new Command.RemoveObstacle(STAND));
        run.advanceTo(15);
        run.undo();
        run.advanceTo(30);
        run.redo();
        assertEquals(Optional.empty(), atStart(STAND));
        assertShown(other);
        run.undo();
        assertEquals(Optional.of(stand), atStart(STAND));
        assertShown(other);
    }

    @Test
    void anEditOfTwoObstaclesIsUndoneForEachAsTheTimelineSays() {
        plan(at(0.2, PLAN));
        Obstacle chair = atStart("chair-1").orElseThrow();
        editBeforeThePlan(EDIT, new Command.MoveObstacle("chair-1", new Pose(3.3, 4.4, 0)));
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(chair), shown("chair-1"));
        run.seek(20);
        run.advanceTo(40);
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(chair), shown("chair-1"));
    }

    @Test
    void anEditOfTheRunBeforeIsUndoneAsTheTimelineSays() {
        plan(at(0.2, PLAN));
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
        assertEquals(Optional.of(stand), atStart(STAND));
    }

    /** A restart that is cancelled leaves the run with the edit at its tick. */
    @Test
    void anEditIsUndoneInTheRunAfterACancelledRestart() {
        plan(at(0.2, PLAN));
        run.advanceTo(30);
        run.send(EDIT);
        runOnEdt(() -> {
            run.controller()
                    .restartAt(run.workspace().scenario().orElseThrow().setup().start());
            run.workspace().cancelTask();
        });
        run.rest();
        run.advanceTo(40);
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), atStart(STAND));
    }

    /** The timeline puts the obstacle where the edit has moved it. */
    @Test
    void anObstacleThatTheTimelineHasPlacedBeforeTheEditReturns() {
        Obstacle placed = new Obstacle("placed", new ObstacleShape.CircleShape(0.1), PLANNED);
        plan(at(0.05, new Command.PlaceObstacle(placed)));
        run.advanceTo(10);
        run.send(new Command.MoveObstacle("placed", EDITED));
        run.restart();
        run.advanceTo(30);
        assertEquals(Optional.of(placed.withPose(EDITED)), shown("placed"));
        run.undo();
        assertEquals(Optional.of(placed), shown("placed"));
        assertSameObstacles();
    }
}
