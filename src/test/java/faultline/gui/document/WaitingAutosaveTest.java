package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Edits that wait for the end of a restart are written to the recovery file as soon as they are made. */
@ExtendWith(EdtChecker.class)
class WaitingAutosaveTest {

    private static final Command SWITCH = new Command.SwitchSensor("left", false);

    @TempDir
    private Path folder;

    private final Workspace workspace = callOnEdt(Workspace::new);
    private final RunController run = callOnEdt(() -> new RunController(workspace));
    private final CountDownLatch end = new CountDownLatch(1);
    private RecoveryStore recovery;
    private Autosave autosave;

    @BeforeEach
    void open() {
        runOnEdt(() -> new DocumentStore(workspace).openShipped("yard.xml"));
        SessionFrames.awaitScenario(workspace);
        // The store of a process that has crashed.
        recovery = new RecoveryStore(folder, Integer.MAX_VALUE, Instant.EPOCH);
        autosave = callOnEdt(() -> new Autosave(workspace, recovery, failure -> {}));
    }

    @AfterEach
    void close() {
        end.countDown();
        runOnEdt(workspace::close);
    }

    private void restart() {
        workspace.setControllerChoice((setup, name) -> {
            try {
                end.await();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
            return setup;
        });
        run.restart();
    }

    @Test
    void anEditThatWaitsIsWrittenWhenItIsMade() throws Exception {
        runOnEdt(() -> {
            restart();
            run.send(List.of(SWITCH), results -> {});
            autosave.saveUnsavedEdits();
        });
        assertFalse(autosave.hasEdits(), "nothing has been edited yet");
        end.countDown();
        Await.until("the edit", autosave::hasEdits);
        RecoveryStore next = new RecoveryStore(folder);
        Await.until("the recovery file", () -> next.findOrphan(Set.of()).isPresent());
        Scenario found = next.findOrphan(Set.of()).orElseThrow().scenario();
        assertEquals(callOnEdt(workspace::scenario), Optional.of(found));
        next.release();
    }
}
