package faultline.gui.action;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.EdtChecker;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

@ExtendWith(EdtChecker.class)
class GhostNoteTest {

    private static final long HALF_A_SECOND = 500_000_000;
    private static final double MANY_HOURS = 80_000;

    private final List<String> kept = new ArrayList<>();
    private Workspace workspace;
    private ComparisonController controller;
    private GhostNote note;
    private long time = Long.MAX_VALUE - HALF_A_SECOND;

    @BeforeEach
    void loadALongRun(@TempDir Path folder) throws Exception {
        Path office = Path.of("scenarios/office.xml");
        Path file = folder.resolve("long.xml");
        Scenario scenario = Scenario.load(office);
        scenario.withSetup(scenario.setup().withDuration(MANY_HOURS)).save(file);
        runOnEdt(() -> {
            workspace = new Workspace();
            controller = new ComparisonController(workspace, new RunController(workspace).navigator());
            note = new GhostNote(controller, new Notes(text -> {}, kept::add, text -> {}, kept::remove), () -> time);
            new DocumentStore(workspace).open(office);
        });
        Await.until("the scenario", () -> workspace.session().isPresent());
        runOnEdt(() -> controller.loadReference(file));
    }

    @AfterEach
    void close() {
        runOnEdt(() -> {
            controller.removeReference();
            workspace.close();
        });
        BackgroundThreads.awaitEnd();
    }

    @Test
    void theProgressIsShownAfterHalfASecondAndNoLongerThanTheGhostIsMade() {
        runOnEdt(() -> {
            note.update();
            time += HALF_A_SECOND;
            note.update();
            assertEquals(List.of(), kept);
            time++;
            note.update();
            assertEquals(List.of("Ghost long.xml: 0 %; Remove ghost cancels"), kept);
        });
        runOnEdt(controller::cancelPending);
        runOnEdt(note::update);
        assertEquals(List.of(), callOnEdt(() -> kept));
    }

    @Test
    void ofALongCommandTheNameOfItsProgramIsShown() {
        assertEquals("good.py", GhostNote.shortName("python3 good.py"));
        assertEquals("my_follower.py", GhostNote.shortName("python3 my_follower.py"));
        assertEquals("good.py", GhostNote.shortName("/usr/bin/python3.11 \"/home/me/my robot/good.py\" --gain 0.5"));
        assertEquals("good.py", GhostNote.shortName("python \"C:\\Users\\me\\good.py\""));
        assertEquals("follower -v", GhostNote.shortName("/home/me/robot/follower -v"));
    }

    @Test
    void aLongNameIsCut() {
        assertEquals("python3 run.py", GhostNote.shortName("python3 run.py"));
        assertEquals("A scenario wi…", GhostNote.shortName("A scenario with a long name"));
        assertEquals("my_right_foll…", GhostNote.shortName("python3 my_right_follower.py"));
    }
}
