package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.RunFailedException;
import faultline.external.ControllerProblem;
import faultline.gui.document.TaskKind;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The sentences of dialogs. */
class DialogsTest {

    @Test
    void aFailureNamesTheFileAndARootFolderByItsPath() {
        Path root = Path.of("").toAbsolutePath().getRoot();
        IOException cause = new IOException("this is a folder");
        assertEquals(root + " cannot be opened: this is a folder.", Dialogs.failureText(TaskKind.OPEN, root, cause));
        assertEquals(
                "room.xml cannot be opened: this is a folder.",
                Dialogs.failureText(TaskKind.OPEN, root.resolve("room.xml"), cause));
    }

    @Test
    void aTracebackHasItsLines() {
        Throwable cause = new RunFailedException(
                ControllerProblem.LAST_LINES.with(
                        "it has stopped", "NameError: gain", "Traceback (most recent call last): | line 3, in drive"),
                null);
        String text = "room.xml cannot be restarted: it has stopped; its last line on standard error: NameError: gain;"
                + " the lines before:\nTraceback (most recent call last):\nline 3, in drive";
        assertEquals(
                text,
                Dialogs.failureText(TaskKind.RESTART, Path.of("room.xml"), cause)
                        .replace(": \n", ":\n"));
    }

    @Test
    void whoOpensAMapAsAScenarioLearnsHowToImportIt() {
        assertEquals(
                "room.xml cannot be opened. The current scenario remains open.",
                Dialogs.headingText(Path.of("room.xml"), true));
        assertEquals(
                "map.PNG cannot be opened. File > Import floor plan opens maps and images. An example is open instead.",
                Dialogs.headingText(Path.of("map.PNG"), false));
    }

    @Test
    void whoOpensAControllerAsAScenarioLearnsHowToChooseIt() {
        String hint = " cannot be opened. Simulation > Choose controller drives the robot with a program or a jar."
                + " The current scenario remains open.";
        assertEquals("robot.py" + hint, Dialogs.headingText(Path.of("robot.py"), true));
        assertEquals("robot.JAR" + hint, Dialogs.headingText(Path.of("robot.JAR"), true));
    }
}
