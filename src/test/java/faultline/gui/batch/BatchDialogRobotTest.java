package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JButton;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The dialog of a batch while files are written. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "creates a dialog, which needs a display")
class BatchDialogRobotTest {

    private static final Path TARGET = Path.of("plan.xml");

    private final CountDownLatch copied = new CountDownLatch(1);
    private JFrame owner;

    @AfterEach
    void close() {
        copied.countDown();
        runOnEdt(owner::dispose);
    }

    /** A start deletes the files of the batch before, which may still be copied. */
    @Test
    void noBatchStartsBeforeAllFilesAreWritten() throws Exception {
        Scenario scenario = Scenario.load(Path.of("scenarios/office.xml"));
        AtomicBoolean first = new AtomicBoolean();
        AtomicBoolean second = new AtomicBoolean();
        BatchDialog dialog = callOnEdt(() -> {
            Theme.LIGHT.install();
            owner = new JFrame();
            BatchDialog shown = new BatchDialog(owner, new BatchSource(scenario, Path.of("office"), () -> {}), null);
            shown.write(TARGET, copied::await, () -> first.set(true));
            shown.write(TARGET, () -> {}, () -> second.set(true));
            return shown;
        });
        JButton start = ComponentFinder.find(dialog, JButton.class, "Start");
        Await.until("the second file is written", second::get);
        assertFalse(callOnEdt(start::isEnabled), "the first is not");
        copied.countDown();
        Await.until("the first file is written", first::get);
        assertTrue(callOnEdt(start::isEnabled));
    }
}
