package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.external.ControllerChoice;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** A controller in a process has its time to end when the window is closed. */
@ExtendWith(EdtChecker.class)
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
class ControllerEndTest {

    /** Never answers, and saves its results when its input has ended, after it has been busy with an observation. */
    private static final String PROGRAM =
            """
            read hello
            echo '{"type":"ready","protocol":1}'
            read observation
            : > 'FOLDER/busy'
            while read line; do :; done
            sleep 0.3
            echo saved > 'FOLDER/results'
            """;

    @TempDir
    private Path folder;

    @Test
    void theProgramExitsAfterTheController() throws Exception {
        Path script = Files.writeString(folder.resolve("slow.sh"), PROGRAM.replace("FOLDER", folder.toString()));
        ControllerChoice selection = ControllerChoice.of("sh '" + script + "'");
        Workspace workspace = callOnEdt(Workspace::new);
        runOnEdt(() -> {
            workspace.setControllerChoice((setup, name) -> selection.applyTo(setup, name, line -> {}));
            new DocumentStore(workspace).openShipped("yard.xml");
        });
        Await.until("the session", () -> workspace.session().isPresent());
        runOnEdt(new RunController(workspace)::toggleRunning);
        Await.until("the busy controller", () -> Files.exists(folder.resolve("busy")));
        CountDownLatch exited = new CountDownLatch(1);
        runOnEdt(() -> {
            workspace.close();
            BackgroundTasks.runAfterAll(exited::countDown);
        });
        assertTrue(exited.await(30, TimeUnit.SECONDS));
        assertTrue(Files.exists(folder.resolve("results")));
    }
}
