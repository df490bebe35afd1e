package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.document.Workspace;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EditNotifierTest {

    @Test
    void theNoteAboutAFailedRunGoesWhenTheRunIsMoved() {
        List<String> shown = new ArrayList<>();
        ActionRegistry actions = new ActionRegistry();
        runOnEdt(() -> {
            actions.add(UiAction.of("restart", () -> {}).withAccelerator(Keystrokes.unmodified(KeyEvent.VK_F5)));
            EditNotifier notifier = new EditNotifier(
                    new Workspace(), actions, new Notes(shown::add, text -> {}, text -> {}, shown::remove));
            notifier.failedRunResumed();
            assertEquals(List.of("The run has failed; restart it with F5, or move it to an earlier time"), shown);
            notifier.runRepositioned(3, null, false);
        });
        assertEquals(List.of(), shown);
    }
}
