package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.bar.StatusBar;
import faultline.gui.document.Workspace;
import java.io.IOException;
import java.nio.file.Path;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class FileNotifierTest {

    private final StatusBar bar = callOnEdt(StatusBar::new);
    private final Workspace workspace = callOnEdt(Workspace::new);
    private final FileNotifier notifier = callOnEdt(() -> new FileNotifier(workspace, bar));

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    private String note() {
        return callOnEdt(() -> ComponentFinder.find(bar, JLabel.class, "Note").getText());
    }

    @Test
    void aFileIsCalledByItsNameWithoutItsFolder() {
        runOnEdt(() -> notifier.scenarioSaved(Path.of("runs", "a.xml")));
        assertEquals("Saved as a.xml", note());
        runOnEdt(() -> notifier.fileDeleted(Path.of("runs", "b.xml")));
        assertEquals("Another program has deleted b.xml", note());
    }

    @Test
    void aSaveThatTakesLongIsNotedUntilItEnds() {
        runOnEdt(() -> notifier.saveSlow(Path.of("runs", "a.xml"), () -> true));
        assertEquals("Still saving a.xml", note());
    }

    @Test
    void editsThatCannotBeKeptForRecoveryAreReported() {
        runOnEdt(() -> notifier.autosaveFailed(new IOException("no space"), () -> true));
        assertTrue(note().startsWith("The unsaved changes cannot be kept for recovery: "), note());
    }
}
