package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
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
    private static final Command OTHER_EDIT = new Command.MoveObstacle("chair-1", new Pose(3.3, 4.4, 0));
    private static final Command PLAN = new Command.MoveObstacle(STAND, PLANNED);

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

    private void plan(TimedCommand... timeline) {
        run.plan(List.of(timeline));
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

    private void assertShown(Obstacle expected) {
        assertEquals(Optional.ofNullable(expected), run.shown(STAND));
        run.assertSameObstacles();
    }

    @Test
    void anObstacleStaysWhereTheTimelineHasMovedIt() {
        plan(at(0.2, PLAN));
        editBeforeThePlan(EDIT);
        for (int i = 0; i < 2; i++) {
            run.undo();
            assertShown(stand.withPose(PLANNED));
            assertEquals(Optional.of(stand), run.atStart(STAND));
            assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
            run.advance(3);
            run.redo();
            assertShown(stand.withPose(PLANNED));
            assertEquals(Optional.of(stand.withPose(EDITED)), run.atStart(STAND));
            assertEquals(Optional.of("Move coat-stand"), callOnEdt(run.edits()::undoName));
            run.advance(3);
        }
    }

    /** The timeline moves the obstacle back to where it starts, so both edits are undone by a move to that place. */
    @Test
    void editsThatTheSameCommandUndoesAreUndoneOneByOne() {
        plan(at(0.2, new Command.MoveObstacle(STAND, stand.pose())));
        editBeforeThePlan(EDIT);
        run.send(new Command.MoveObstacle(STAND, PLANNED));
        run.undo();
        assertEquals(Optional.of(stand.withPose(EDITED)), run.atStart(STAND));
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
        run.redo();
        run.redo();
        assertEquals(Optional.of(stand.withPose(PLANNED)), run.atStart(STAND));
        run.restart();
        run.undo();
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    @Test
    void anUndoThatTheRunDoesNotShowIsReported() {
        List<String> notes = new ArrayList<>();
        runOnEdt(() -> run.edits().setScenarioListener((name, redone) -> notes.add(name + " " + redone)));
        plan(at(0.2, PLAN));
        editBeforeThePlan(EDIT);
        String name = callOnEdt(run.edits()::undoName).orElseThrow();
        run.undo();
        run.redo();
        assertEquals(List.of(name + " false", name + " true"), notes);
        run.seek(15);
        run.undo();
        assertEquals(2, notes.size(), "the run shows this undo");
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
        assertEquals(Optional.of(stand), run.atStart(STAND));
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
        assertEquals(Optional.of(stand), run.atStart(STAND));
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
        assertEquals(Optional.of(stand.withPose(last)), run.shown(STAND));
        run.undo();
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), run.atStart(STAND));
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
        assertEquals(Optional.of(stand), run.atStart(STAND));
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
        assertEquals(Optional.of(stand.withPose(EDITED)), run.atStart(STAND));
    }

    @Test
    void anEditAfterTheTimelineIsUndoneInTheRun() {
        plan(at(0.2, PLAN));
        run.advanceTo(30);
        run.send(EDIT);
        run.advanceTo(40);
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    @Test
    void theRunIsWhatItWasWhereverItIsMoved() {
        plan(at(0.2, PLAN));
        editBeforeThePlan(EDIT);
        run.undo();
        run.advanceTo(40);
        run.seek(15);
        assertEquals(Optional.of(stand.withPose(EDITED)), run.shown(STAND));
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
        assertEquals(Optional.of(stand), run.atStart(STAND));
        run.advanceTo(50);
        assertShown(stand.withPose(PLANNED));
        assertEquals(elsewhere, run.shown("chair-1").orElseThrow().pose());
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
        assertEquals(Optional.of(stand), run.atStart(STAND));
        run.redo();
        assertShown(larger.withPose(PLANNED));
        assertEquals(Optional.of(larger), run.atStart(STAND));
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
        assertEquals(Optional.of(stand.withPose(PLANNED)), run.shown(STAND));
        assertEquals(Optional.of(stand), run.atStart(STAND));
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
        assertEquals(Optional.of(stand), run.atStart(STAND));
    }

    @Test
    void anObstacleThatTheTimelineHasReplacedIsRestoredInTheScenario() {
        Obstacle other = new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), PLANNED);
        plan(at(0.2, new Command.PlaceObstacle(other)));
        editBeforeThePlan(EDIT);
        run.undo();
        assertShown(other);
        assertEquals(Optional.of(stand), run.atStart(STAND));
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
        assertEquals(Optional.empty(), run.atStart(STAND));
        assertShown(other);
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
        assertShown(other);
    }

    @Test
    void anEditOfTwoObstaclesIsUndoneForEachAsTheTimelineSays() {
        plan(at(0.2, PLAN));
        Obstacle chair = run.atStart("chair-1").orElseThrow();
        editBeforeThePlan(EDIT, new Command.MoveObstacle("chair-1", new Pose(3.3, 4.4, 0)));
        run.undo();
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(chair), run.shown("chair-1"));
        run.seek(20);
        run.advanceTo(40);
        assertShown(stand.withPose(PLANNED));
        assertEquals(Optional.of(chair), run.shown("chair-1"));
    }

    /** The edit is done again when the run has passed the timeline's move, unlike the first time. */
    @Test
    void aSizeThatIsRedoneAfterAnEarlierEditReturnsWhereTheTimelineHasMovedTheObstacle() {
        plan(at(0.3, PLAN));
        run.advanceTo(20);
        run.send(new Command.PlaceObstacle(new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), stand.pose())));
        run.seek(10);
        run.send(OTHER_EDIT);
        run.advanceTo(40);
        run.redo();
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
        assertEquals(Optional.of(stand.withPose(PLANNED)), run.shown(STAND));
    }

    /** The edit was made when the timeline had placed another obstacle of this id. */
    @Test
    void anEditIsRedoneForTheObstacleOfItsFirstExecutionInTheRun() {
        plan(at(0.3, new Command.PlaceObstacle(stand.withPose(PLANNED))));
        List<TimedCommand> planned = run.timeline();
        run.advanceTo(40);
        run.send(EDIT);
        run.seek(10);
        run.redo();
        run.undo();
        run.advanceTo(50);
        run.redo();
        assertEquals(planned, run.timeline());
        assertShown(stand.withPose(PLANNED));
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
        assertEquals(planned, run.timeline());
        assertShown(stand.withPose(PLANNED));
    }

    @Test
    void aRemovalIsRedoneAfterTheTimelineHasPlacedAndRemovedAnotherObstacle() {
        plan(at(0.1, new Command.PlaceObstacle(stand.withPose(PLANNED))), at(0.2, new Command.RemoveObstacle(STAND)));
        run.advanceTo(5);
        run.send(new Command.RemoveObstacle(STAND));
        run.seek(2);
        run.send(OTHER_EDIT);
        run.advanceTo(30);
        run.redo();
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
        assertEquals(Optional.empty(), run.shown(STAND));
    }

    /** Drags the stand from a tick before the plan to a tick after it. */
    private void dragDuringThePlan() {
        run.advanceTo(10);
        runOnEdt(run.sender()::beginGesture);
        run.drag(new Command.MoveObstacle(STAND, new Pose(5.4, 4.2, 0)));
        run.drag(new Command.MoveObstacle(STAND, new Pose(5.4, 4.4, 0)));
        run.advanceTo(30);
        run.drag(new Command.MoveObstacle(STAND, new Pose(5.4, 4.5, 0)));
        run.drag(EDIT);
        runOnEdt(run.sender()::endGesture);
    }

    @Test
    void anObstacleIsWhereTheTimelineHasMovedItDuringADragThatIsUndone() {
        plan(at(0.2, PLAN));
        dragDuringThePlan();
        assertEquals(Optional.of("Move " + STAND), callOnEdt(run.edits()::undoName));
        for (int i = 0; i < 2; i++) {
            run.undo();
            assertShown(stand.withPose(PLANNED));
            assertEquals(Optional.of(stand), run.atStart(STAND));
            run.redo();
            assertEquals(Optional.of(stand.withPose(EDITED)), run.shown(STAND));
        }
        run.undo();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
    }

    @Test
    void theUndoOfADragRestoresAnObstacleThatTheTimelineHasPlacedDuringIt() {
        Obstacle placed = new Obstacle(STAND, new ObstacleShape.CircleShape(0.1), PLANNED);
        plan(at(0.2, new Command.PlaceObstacle(placed)));
        List<TimedCommand> timeline = run.timeline();
        dragDuringThePlan();
        run.undo();
        assertShown(placed);
        assertEquals(Optional.of(stand), run.atStart(STAND));
        assertEquals(timeline, run.timeline());
        run.redo();
        run.restart();
        run.undo();
        assertEquals(Optional.of(stand), run.atStart(STAND));
        assertEquals(timeline, run.timeline());
    }
}
