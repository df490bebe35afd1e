package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Tests new ids of obstacles before and during a run, which is simulated again. */
@ExtendWith(EdtChecker.class)
class ObstacleEditorTest {

    private static final Pose ASIDE = new Pose(5.6, 3.4, 0);
    private static final Pose FAR = new Pose(6, 3, 0);

    @TempDir
    private Path folder;

    private final EditedRun run = new EditedRun();
    private final Scenario original = run.scenario();

    @AfterEach
    void close() {
        run.close();
    }

    private static TimedCommand timed(double time, Command command) {
        return new TimedCommand(time, command);
    }

    private List<String> idsAtStart() {
        return run.scenario().setup().world().obstacles().stream()
                .map(Obstacle::id)
                .toList();
    }

    private List<String> shownIds() {
        return SessionFrames.frame(run.workspace()).snapshot().obstacles().stream()
                .map(Obstacle::id)
                .toList();
    }

    private long hash() {
        return SessionFrames.trajectoryHash(run.workspace());
    }

    private void undoAll() {
        while (callOnEdt(run.edits()::canUndo)) {
            run.undo();
        }
    }

    @Test
    void theWorldAndTheTimelineHaveTheNewIdAndTheRunStaysTheSame() throws ScenarioException, IOException {
        run.plan(List.of(
                timed(0.2, new Command.MoveObstacle("coat-stand", ASIDE)),
                timed(0.3, new Command.RemoveObstacle("chair-1")),
                timed(0.9, new Command.RemoveObstacle("coat-stand"))));
        Scenario planned = run.scenario();
        run.advance(40);
        long hash = hash();
        assertEquals(Optional.empty(), run.rename("coat-stand", "a & <b> 'ä'"));
        assertEquals(
                List.of("desk", "cabinet", "copier", "cut-corner", "table", "chair-1", "chair-2", "a & <b> 'ä'"),
                idsAtStart(),
                "at its place");
        assertEquals(
                List.of(
                        timed(0.2, new Command.MoveObstacle("a & <b> 'ä'", ASIDE)),
                        timed(0.3, new Command.RemoveObstacle("chair-1")),
                        timed(0.9, new Command.RemoveObstacle("a & <b> 'ä'"))),
                run.timeline());
        assertEquals(ASIDE, run.shown("a & <b> 'ä'").orElseThrow().pose());
        assertEquals(40, run.tick());
        assertEquals(hash, hash());
        Path file = Files.write(folder.resolve("renamed.xml"), run.scenario().toBytes());
        assertEquals(run.scenario(), Scenario.load(file), "as the file that is saved");
        assertEquals(Optional.of("Rename coat-stand to a & <b> 'ä'"), callOnEdt(run.edits()::undoName));
        run.undo();
        assertEquals(planned, run.scenario());
        assertEquals(hash, hash());
        run.redo();
        assertEquals("a & <b> 'ä'", shownIds().get(6), "without the chair");
    }

    @Test
    void anIdThatIsTakenOrReservedOrThatAFileCannotHaveIsRefused() {
        String invalid = "An id has 1 to 100 characters, none of them a comma, a double quote or a control character";
        run.plan(List.of(timed(
                5,
                new Command.PlaceObstacle(
                        original.setup().world().obstacles().get(5).withId("later")))));
        String taken = "The scenario already has an obstacle with the id ";
        assertEquals(Optional.of(taken + "desk"), run.rename("chair-1", "desk"));
        assertEquals(Optional.of(taken + "later"), run.rename("chair-1", "later"));
        assertEquals(Optional.of("enclosure is the name of the enclosing wall"), run.rename("chair-1", "enclosure"));
        for (String wrong : List.of("", "a,b", "a\"b", "a\tb", "x".repeat(101))) {
            assertEquals(Optional.of(invalid), run.rename("chair-1", wrong), wrong);
        }
        assertEquals(Optional.empty(), run.rename("chair-1", "chair-1"));
        assertEquals(Optional.empty(), run.rename("none", "other"));
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        assertEquals(Optional.empty(), run.rename("later", "x".repeat(100)));
        assertTrue(((Command.PlaceObstacle) run.timeline().get(0).command())
                .obstacle()
                .id()
                .equals("x".repeat(100)));
    }

    /** What was done during the run stays there, so the run reaches it again, and all of it can be undone. */
    @Test
    void theCommandsOfTheRunKeepTheirTicks() {
        run.advance(20);
        run.send(new Command.MoveObstacle("coat-stand", ASIDE));
        run.advance(20);
        run.send(new Command.RemoveObstacle("chair-1"));
        run.advance(5);
        long hash = hash();
        run.rename("coat-stand", "pole");
        assertEquals(hash, hash());
        assertEquals(ASIDE, run.atStart("pole").orElseThrow().pose());
        run.seek(10);
        assertEquals(
                original.setup().world().obstacles().get(7).withId("pole"),
                run.shown("pole").orElseThrow());
        run.advanceTo(50);
        assertEquals(ASIDE, run.shown("pole").orElseThrow().pose());
        assertEquals(Optional.empty(), run.shown("chair-1"));
        undoAll();
        assertEquals(original, run.scenario());
    }

    /** A removed obstacle that had the id keeps another one, so that its removal can be undone. */
    @Test
    void theIdOfARemovedObstacleIsFree() {
        run.send(new Command.RemoveObstacle("chair-1"));
        run.rename("chair-2", "chair-1");
        run.send(new Command.MoveObstacle("chair-1", FAR));
        assertEquals(
                List.of("desk", "cabinet", "copier", "cut-corner", "table", "chair-1", "coat-stand"), idsAtStart());
        run.restart();
        run.advance(10);
        assertEquals(FAR, run.shown("chair-1").orElseThrow().pose());
        undoAll();
        assertEquals(original, run.scenario());
        run.redo();
        run.redo();
        assertEquals(List.of("chair-1", "coat-stand"), idsAtStart().subList(5, 7));
    }

    @Test
    void anEditOfAnEarlierRunIsUndoneAfterARenaming() {
        run.plan(List.of(timed(0.5, new Command.MoveObstacle("chair-1", FAR))));
        Scenario planned = run.scenario();
        run.advance(60);
        run.send(new Command.MoveObstacle("chair-1", ASIDE));
        run.rename("chair-1", "stool");
        run.restart();
        run.send(new Command.RemoveObstacle("stool"));
        run.restart();
        run.advance(10);
        undoAll();
        assertEquals(planned, run.scenario());
    }

    @Test
    void quickUndosOfAnEarlierRunFollowTheRenamingBetweenThem() {
        run.send(new Command.MoveObstacle("chair-1", FAR));
        run.rename("coat-stand", "pole");
        run.send(new Command.MoveObstacle("pole", ASIDE));
        run.restart();
        runOnEdt(() -> {
            run.edits().undo();
            run.edits().undo();
        });
        run.rest();
        Await.until("both undos", () -> run.edits().undoName().equals(Optional.of("Move chair-1")));
        assertEquals(
                original.setup().world().obstacles().get(7),
                run.atStart("coat-stand").orElseThrow());
        undoAll();
        assertEquals(original, run.scenario());
    }

    @Test
    void aCommandThatIsOnItsWayIsNotLost() {
        runOnEdt(() -> {
            run.sender().send(new Command.MoveObstacle("coat-stand", ASIDE));
            run.obstacles().rename("coat-stand", "pole");
            run.sender().send(new Command.MoveObstacle("chair-1", FAR));
            // The views still have the old id.
            run.sender().send(new Command.RemoveObstacle("coat-stand"));
            run.obstacles().rename("pole", "mast");
        });
        run.rest();
        Await.until("all commands", () -> run.edits().undoName().equals(Optional.of("Delete mast")));
        assertEquals(FAR, run.atStart("chair-1").orElseThrow().pose());
        assertEquals(Optional.empty(), run.shown("mast"));
        undoAll();
        assertEquals(original, run.scenario());
    }

    /** The run still has the old id, so what the window shows can be used, and what was done before can be undone. */
    @Test
    void anObstacleCanBeUsedAfterTheSimulationOfItsRenamingWasCancelled() {
        run.send(new Command.MoveObstacle("coat-stand", ASIDE));
        runOnEdt(() -> {
            run.obstacles().rename("coat-stand", "mast");
            run.obstacles().rename("mast", "pole");
            run.workspace().cancelTask();
        });
        assertTrue(run.shown("coat-stand").isPresent());
        assertEquals("pole", callOnEdt(() -> run.obstacles()
                .editedId(run.shown("coat-stand").orElseThrow())));
        run.send(new Command.MoveObstacle("coat-stand", FAR));
        assertEquals(Optional.of("Move pole"), callOnEdt(run.edits()::undoName));
        assertEquals(FAR, run.shown("coat-stand").orElseThrow().pose());
        run.undo();
        assertEquals(ASIDE, run.shown("coat-stand").orElseThrow().pose());
        run.redo();
        run.advance(5);
        run.seek(3);
        assertEquals(FAR, run.shown("pole").orElseThrow().pose());
        undoAll();
        assertEquals(original, run.scenario());
    }
}
