package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;

import faultline.gui.Await;
import faultline.gui.document.TaskKind;
import faultline.gui.document.TaskProgress;
import faultline.gui.document.WorkspaceTask;
import java.awt.Dialog.ModalityType;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The dialog of a task waits for modal dialogs only. */
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "opens a dialog, which needs a display")
class ProgressDialogsRobotTest {

    /** More than the dialog waits for. */
    private static final int POLLS = 60;

    private final WorkspaceTask task = new WorkspaceTask(TaskKind.OPEN, Path.of("room.xml"), new TaskProgress());
    private final JFrame owner = callOnEdt(JFrame::new);
    private final ProgressDialogs dialogs = new ProgressDialogs(owner, () -> {});

    @AfterEach
    void close() {
        runOnEdt(() -> {
            dialogs.clear();
            owner.dispose();
        });
    }

    @ParameterizedTest
    @EnumSource(names = {"MODELESS", "APPLICATION_MODAL"})
    void onlyAModalDialogDelaysTheDialogOfATask(ModalityType modality) {
        JDialog other = callOnEdt(() -> new JDialog(owner, "other", modality));
        // Asynchronously: the method returns when a modal dialog is closed.
        EventQueue.invokeLater(() -> other.setVisible(true));
        Await.until("the other dialog", other::isShowing);
        runOnEdt(() -> {
            for (int i = 0; i < POLLS; i++) {
                dialogs.update(task);
            }
        });
        long expected = modality == ModalityType.MODELESS ? 1 : 0;
        Await.until("the dialog, which opens by an event of its own", () -> countProgressDialogs() == expected);
    }

    private long countProgressDialogs() {
        return Stream.of(owner.getOwnedWindows())
                .filter(window -> window instanceof ProgressDialog && window.isShowing())
                .count();
    }
}
