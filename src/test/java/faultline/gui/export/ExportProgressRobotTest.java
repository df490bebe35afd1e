package faultline.gui.export;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.document.TaskProgress;
import java.awt.Window;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.io.TempDir;

/** A long export shows its progress within a second, long before one per cent is done. */
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "opens a dialog, which needs a display")
class ExportProgressRobotTest {

    private static final int STEPS = 10_000;
    private static final long STEP_NANOS = 20_000_000;

    @TempDir
    private Path folder;

    @Test
    void anExportCanBeCancelledBeforeItsFirstPercent() {
        assertCancellable(ExportProgressRobotTest::writeSlowly);
    }

    @Test
    void anExportWhoseFirstStepIsSlowShowsItsDialogAndCanBeCancelled() {
        assertCancellable((out, progress) -> {
            while (progress.isActive()) {
                LockSupport.parkNanos(STEP_NANOS);
            }
            progress.throwIfCancelled();
        });
    }

    private void assertCancellable(FileExport export) {
        Path file = folder.resolve("long.gif");
        List<Object> ends = new ArrayList<>();
        ExportTask task = callOnEdt(() -> new ExportTask(null, export, file, () -> {}, ends::add, ends::add));
        runOnEdt(task::start);
        Await.until("the dialog", () -> shownDialog().isPresent());
        runOnEdt(() -> ComponentFinder.findAll(shownDialog().orElseThrow(), JButton.class)
                .findFirst()
                .orElseThrow()
                .doClick(0));
        Await.until("the end of the task", () -> task.isDone() && !ends.isEmpty());
        assertFalse(Files.exists(file));
        assertEquals(1, ends.size());
        assertInstanceOf(CancellationException.class, ends.get(0));
    }

    private static Optional<JDialog> shownDialog() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(JDialog::isShowing)
                .findFirst();
    }

    /** Reports less than one per cent until it is cancelled. */
    private static void writeSlowly(OutputStream out, TaskProgress progress) {
        for (int step = 0; progress.isActive(); step = Math.min(step + 1, STEPS / 100 - 1)) {
            progress.setFraction((double) step / STEPS);
            LockSupport.parkNanos(STEP_NANOS);
        }
        progress.throwIfCancelled();
    }
}
