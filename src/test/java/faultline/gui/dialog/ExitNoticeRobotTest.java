package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import java.awt.Window;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;

/** A program that cannot end after its window was closed says so, and ends on request. */
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "opens a dialog, which needs a display")
class ExitNoticeRobotTest {

    private static final int DELAY_MILLIS = 200;

    private final AtomicInteger exits = new AtomicInteger();
    private final ExitNotice notice = callOnEdt(() -> new ExitNotice(exits::incrementAndGet, DELAY_MILLIS));

    @AfterEach
    void close() {
        runOnEdt(notice::close);
        assertEquals(List.of(), callOnEdt(ExitNoticeRobotTest::shown));
    }

    private static List<JDialog> shown() {
        return Stream.of(Window.getWindows())
                .filter(window -> window instanceof JDialog dialog && dialog.isShowing())
                .map(JDialog.class::cast)
                .toList();
    }

    private static JDialog awaitDialog() {
        Await.until("the question", () -> shown().size() == 1);
        return callOnEdt(() -> shown().get(0));
    }

    private static void answer(String button) {
        JDialog dialog = awaitDialog();
        runOnEdt(() -> ComponentFinder.find(dialog, JButton.class, button).doClick());
        Await.until("the end of the question", () -> !dialog.isShowing());
    }

    @Test
    void theUserCanEndTheProgram() {
        answer("Exit now");
        assertEquals(1, exits.get());
    }

    @Test
    void theUserIsAskedAgainAfterAWait() {
        answer("Wait");
        assertEquals(0, exits.get());
        answer("Exit now");
        assertEquals(1, exits.get());
    }
}
