package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Gestures of a run that is moved, and gestures that restore what they have changed. */
@ExtendWith(EdtChecker.class)
class GestureUndoTest {

    private static final String CHAIR = "chair-1";
    private static final Pose FIRST = new Pose(3, 4.5, 0);
    private static final Pose SECOND = new Pose(3.2, 4.5, 0);

    private EditedRun run;
    private Scenario initial;
    private Pose initialPose;

    @BeforeEach
    void open() {
        run = new EditedRun();
        initial = run.scenario();
        initialPose = pose();
    }

    @AfterEach
    void close() {
        run.close();
    }

    private Pose pose() {
        return run.atStart(CHAIR).orElseThrow().pose();
    }

    private static Command move(Pose pose) {
        return new Command.MoveObstacle(CHAIR, pose);
    }

    private static Command resize(double radius, Pose pose) {
        return new Command.PlaceObstacle(new Obstacle(CHAIR, new ObstacleShape.CircleShape(radius), pose));
    }

    /** Drags the chair at tick 1 and on at tick 6. */
    private void drag(Pose first, Pose second) {
        run.advance(1);
        runOnEdt(run.sender()::beginGesture);
        run.drag(move(first));
        run.advance(5);
        run.drag(move(second));
        runOnEdt(run.sender()::endGesture);
    }

    private void forkAt(long tick) {
        run.seek(tick);
        run.send(new Command.SetPlatform(0.3, 0.2, 0.1));
    }

    @Test
    void aDragIsRedoneAsFarAsTheRunHadExecutedIt() {
        drag(FIRST, SECOND);
        forkAt(3);
        Scenario edited = run.scenario();
        run.undo();
        run.undo();
        assertEquals(initial, run.scenario());
        run.redo();
        assertEquals(FIRST, pose());
        run.redo();
        assertEquals(edited, run.scenario());
    }

    @Test
    void aDragThatIsUndoneInItsMiddleIsRedoneAsFarAsThat() {
        drag(FIRST, SECOND);
        run.seek(3);
        run.undo();
        assertEquals(initialPose, pose());
        run.redo();
        assertEquals(FIRST, pose());
        assertEquals(FIRST, run.shown(CHAIR).orElseThrow().pose());
    }

    @Test
    void aDragIsWholeAfterAMoveThroughItsMiddle() {
        drag(FIRST, SECOND);
        run.seek(3);
        run.advance(4);
        run.undo();
        assertEquals(initialPose, pose());
        run.redo();
        assertEquals(SECOND, pose());
    }

    @Test
    void aDragThatBeginsAtTheStartIsTwoEdits() {
        runOnEdt(run.sender()::beginGesture);
        run.drag(move(FIRST));
        run.advance(5);
        run.drag(move(SECOND));
        runOnEdt(run.sender()::endGesture);
        run.undo();
        assertEquals(FIRST, run.shown(CHAIR).orElseThrow().pose());
        run.undo();
        assertEquals(initial, run.scenario());
    }

    @Test
    void aCancelledDragDoesNotReturnWithAMove() {
        run.advance(5);
        runOnEdt(run.sender()::beginGesture);
        run.drag(move(FIRST));
        run.drag(move(initialPose));
        runOnEdt(run.sender()::endGesture);
        run.advance(5);
        run.seek(2);
        assertFalse(callOnEdt(run.edits()::canRedo));
        run.advance(8);
        assertFalse(callOnEdt(run.edits()::canUndo));
    }

    @Test
    void aCancelledDragCanBeUndoneInItsMiddle() {
        drag(FIRST, initialPose);
        assertFalse(callOnEdt(run.edits()::canUndo));
        forkAt(3);
        assertEquals(FIRST, pose());
        run.undo();
        run.undo();
        assertEquals(initial, run.scenario());
    }

    @Test
    void keysDuringADragAreRedoneInTheirOrder() {
        runOnEdt(run.sender()::beginGesture);
        run.drag(resize(0.3, FIRST));
        run.drag(move(SECOND));
        run.drag(resize(0.4, FIRST));
        runOnEdt(run.sender()::endGesture);
        Scenario edited = run.scenario();
        run.undo();
        assertEquals(initial, run.scenario());
        run.redo();
        assertEquals(edited, run.scenario());
    }

    @Test
    void aQuickChangeOfTheSetupAndItsReverseAreNoStep() {
        ScenarioEditor properties = callOnEdt(() -> new ScenarioEditor(run.controller(), run.edits()));
        run.send(move(FIRST));
        long seed = initial.setup().seed();
        runOnEdt(() -> setSeed(properties, seed + 1, seed));
        runOnEdt(() -> setSeed(properties, seed, seed + 1));
        run.rest();
        run.undo();
        assertEquals(initialPose, pose());
    }

    private static void setSeed(ScenarioEditor properties, long seed, long before) {
        properties.edit(
                "edit.properties",
                open -> open.withSetup(open.setup().withSeed(seed)),
                open -> open.withSetup(open.setup().withSeed(before)));
    }
}
