package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import javax.swing.JEditorPane;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The open guide after a change of language, text size or theme. */
@ExtendWith(EdtChecker.class)
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "opens a dialog, which needs a display")
class GuideDialogRobotTest {

    private final CountDownLatch released = new CountDownLatch(1);
    /** What loads the next pages, in order. */
    private final ConcurrentLinkedQueue<Callable<GuidePage>> loads = new ConcurrentLinkedQueue<>();

    private GuideDialog dialog;
    private JEditorPane pane;

    @AfterEach
    void release() {
        released.countDown();
        BackgroundThreads.awaitEnd();
    }

    private void open() {
        GuidePage first = GuidePage.load();
        dialog = callOnEdt(() -> {
            Theme.LIGHT.install();
            return new GuideDialog(new JFrame(), first, () -> loads.remove().call());
        });
        pane = ComponentFinder.findAll(dialog, JEditorPane.class).findFirst().orElseThrow();
    }

    private void refresh() {
        RefreshSteps.run(dialog.getRootPane());
    }

    @Test
    void aPageThatIsLoadedAfterThatOfALaterChangeIsNotShown() throws InterruptedException {
        open();
        GuidePage early = GuidePage.load();
        GuidePage late = GuidePage.load();
        CountDownLatch begun = new CountDownLatch(1);
        loads.add(() -> {
            begun.countDown();
            released.await();
            return early;
        });
        runOnEdt(() -> {
            dialog.setVisible(true);
            refresh();
        });
        begun.await();
        loads.add(() -> late);
        runOnEdt(this::refresh);
        Await.until("the page of the later change", () -> pane.getDocument() == late.document());
        released.countDown();
        BackgroundThreads.awaitEnd();
        assertSame(late.document(), callOnEdt(pane::getDocument));
    }

    @Test
    void aGuideThatDoesNotShowChangesItsTitleOnly() {
        open();
        loads.add(GuidePage::load);
        assertEquals("User guide", callOnEdt(dialog::getTitle));
        runOnEdt(() -> {
            Messages.setLanguage(Language.POLISH);
            refresh();
        });
        assertEquals("Podręcznik", callOnEdt(dialog::getTitle));
        BackgroundThreads.awaitEnd();
        assertEquals(1, loads.size(), "no page has been loaded");
    }
}
