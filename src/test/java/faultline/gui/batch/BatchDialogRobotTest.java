package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.BorderLayout;
import java.awt.Component;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
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
    private Scenario scenario;
    private JFrame owner;

    @BeforeEach
    void load() throws ScenarioException {
        scenario = Scenario.load(Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        copied.countDown();
        runOnEdt(owner::dispose);
    }

    /** Creates a dialog of the owner. Event dispatch thread only. */
    private BatchDialog create() {
        Theme.LIGHT.install();
        return new BatchDialog(owner, new BatchSource(scenario, Path.of("office"), () -> {}), null);
    }

    /** Without a focused component, keys have no effect. */
    @Test
    void theFocusReturnsToWhereItWas() {
        JTextField field = callOnEdt(() -> new JTextField(9));
        BatchDialog dialog = callOnEdt(() -> {
            owner = new JFrame();
            owner.add(new JTextField(9), BorderLayout.NORTH);
            owner.add(field, BorderLayout.SOUTH);
            owner.pack();
            owner.setVisible(true);
            return create();
        });
        runOnEdt(field::requestFocus);
        Await.until("the field has the focus", field::isFocusOwner);
        runOnEdt(() -> dialog.setVisible(true));
        Await.until("a field of the dialog has the focus", () -> dialog.getFocusOwner() instanceof JTextField);
        Component focused = callOnEdt(dialog::getFocusOwner);
        runOnEdt(dialog::bringToFront);
        assertSame(focused, callOnEdt(dialog::getFocusOwner));
        runOnEdt(dialog::close);
        Await.until("the field has the focus again", field::isFocusOwner);
    }

    /** A start deletes the files of the batch before, which may still be copied. */
    @Test
    void noBatchStartsBeforeAllFilesAreWritten() throws Exception {
        AtomicBoolean first = new AtomicBoolean();
        AtomicBoolean second = new AtomicBoolean();
        BatchDialog dialog = callOnEdt(() -> {
            owner = new JFrame();
            BatchDialog shown = create();
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
