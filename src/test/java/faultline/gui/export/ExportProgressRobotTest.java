package faultline.gui.export;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.document.TaskProgress;
import java.awt.AWTEvent;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.WindowEvent;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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

    @Test
    void theDialogsOfTwoExportsDoNotCoverEachOther() {
        List<Object> ends = new ArrayList<>();
        List<ExportTask> tasks = Stream.of("a.gif", "b.gif")
                .map(name -> startTask(ExportProgressRobotTest::writeSlowly, folder.resolve(name), ends))
                .toList();
        Await.until("the dialogs", () -> shownDialogs().size() == 2);
        runOnEdt(() -> {
            Rectangle first = shownDialogs().get(0).getBounds();
            Rectangle second = shownDialogs().get(1).getBounds();
            assertFalse(first.intersects(second), first + " and " + second);
        });
        runOnEdt(() -> tasks.forEach(ExportTask::cancel));
        Await.until("the end of the tasks", () -> ends.size() == 2);
    }

    /** The dialog would open after 0.7 s if the export reported no progress. */
    @Test
    void anExportThatIsNearlyCompleteOpensNoDialog() {
        List<Object> ends = new ArrayList<>();
        long end = System.nanoTime() + 1_200_000_000;
        List<Object> shown = new ArrayList<>();
        AWTEventListener listener = event -> {
            if (event.getID() == WindowEvent.WINDOW_OPENED) {
                shown.add(event.getSource());
            }
        };
        Toolkit.getDefaultToolkit().addAWTEventListener(listener, AWTEvent.WINDOW_EVENT_MASK);
        try {
            startTask(
                    (out, progress) -> {
                        progress.setFraction(0.9);
                        while (System.nanoTime() < end) {
                            LockSupport.parkNanos(STEP_NANOS);
                        }
                    },
                    folder.resolve("short.gif"),
                    ends);
            Await.until("the end of the task", () -> !ends.isEmpty());
        } finally {
            Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
        }
        runOnEdt(() -> assertEquals(List.of(), shown));
    }

    private static ExportTask startTask(FileExport export, Path file, List<Object> ends) {
        return callOnEdt(() -> {
            ExportTask task = new ExportTask(null, export, file, () -> {}, ends::add, ends::add);
            task.start();
            return task;
        });
    }

    private void assertCancellable(FileExport export) {
        Path file = folder.resolve("long.gif");
        List<Object> ends = new ArrayList<>();
        ExportTask task = startTask(export, file, ends);
        Await.until("the dialog", () -> !shownDialogs().isEmpty());
        runOnEdt(() -> ComponentFinder.findAll(shownDialogs().get(0), JButton.class)
                .findFirst()
                .orElseThrow()
                .doClick(0));
        Await.until("the end of the task", () -> task.isDone() && !ends.isEmpty());
        assertFalse(Files.exists(file));
        assertEquals(1, ends.size());
        assertInstanceOf(CancellationException.class, ends.get(0));
    }

    private static List<JDialog> shownDialogs() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(JDialog::isShowing)
                .toList();
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
