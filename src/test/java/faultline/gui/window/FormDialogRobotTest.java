package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.GuiRobot;
import faultline.gui.form.FormDialog;
import faultline.gui.form.NumberSpinner;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.GridLayout;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.JToolTip;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A form that is larger than the screen, as many are on small screens and with large text, and one that grows while it
 * is open.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class FormDialogRobotTest {

    private final GuiRobot robot = new GuiRobot();

    @Test
    void aFormThatIsTooLargeScrollsBetweenItsButtonsAndTheTitle() {
        List<JTextField> fields = callOnEdt(() -> {
            Theme.LIGHT.install();
            return Stream.generate(() -> new JTextField(12)).limit(80).toList();
        });
        AtomicBoolean accepted = new AtomicBoolean();
        EventQueue.invokeLater(() -> {
            JPanel form = new JPanel(new GridLayout(0, 1));
            fields.forEach(form::add);
            accepted.set(FormDialog.showDialog(null, "Tall", form, fields.get(0)));
        });
        robot.waitFor("the first field has the focus", fields.get(0)::isFocusOwner);
        Window dialog =
                callOnEdt(() -> fields.get(0).getFocusCycleRootAncestor() instanceof Window window ? window : null);
        Rectangle screen = callOnEdt(
                () -> GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds());
        robot.waitFor("the dialog is on the screen", () -> screen.contains(dialog.getBounds()));
        assertTrue(callOnEdt(() -> ComponentFinder.findAll(dialog, JButton.class)
                .filter(button -> "OK".equals(button.getText()))
                .allMatch(FormDialogRobotTest::isWhole)));
        JTextField last = fields.get(fields.size() - 1);
        runOnEdt(() -> fields.get(fields.size() - 2).requestFocusInWindow());
        robot.waitFor("the last field but one has the focus", fields.get(fields.size() - 2)::isFocusOwner);
        robot.pressKeys(KeyEvent.VK_TAB);
        robot.waitFor("the last field shows", () -> last.isFocusOwner() && isWhole(last));
        robot.pressKeys(KeyEvent.VK_ENTER);
        robot.waitFor("the form is accepted", accepted::get);
    }

    @Test
    void aDialogGrowsWithItsFormAndStaysOnTheScreen() {
        List<JComponent> fields = callOnEdt(() -> {
            Theme.LIGHT.install();
            return List.of(new JTextField(12), new JSpinner(), new JTextField(12));
        });
        JComponent first = fields.get(0);
        JComponent hidden = fields.get(1);
        EventQueue.invokeLater(() -> {
            Box form = Box.createVerticalBox();
            fields.forEach(form::add);
            hidden.setVisible(false);
            FormDialog.showDialog(null, "Growing", form, first);
        });
        robot.waitFor("the first field has the focus", first::isFocusOwner);
        Window dialog = callOnEdt(() -> SwingUtilities.getWindowAncestor(first));
        Rectangle screen = callOnEdt(
                () -> GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds());
        runOnEdt(() -> dialog.setLocation(screen.width - dialog.getWidth(), screen.height - dialog.getHeight()));
        // Java may not learn of the second of two moves in quick succession.
        robot.waitUntilPlaced(dialog);
        runOnEdt(() -> hidden.setVisible(true));
        robot.waitFor(
                "all fields show",
                () -> hidden.getHeight() > 0
                        && fields.stream().allMatch(FormDialogRobotTest::isWhole)
                        && screen.contains(dialog.getBounds()));
        robot.pressKeys(KeyEvent.VK_ESCAPE);
        robot.waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    /** Their notes are in the dialog that ends. */
    @Test
    void aDialogClosesWithTheNotesOfSeveralInvalidFields() {
        List<NumberSpinner> fields = callOnEdt(() -> {
            Theme.LIGHT.install();
            return Stream.generate(() -> new NumberSpinner("0.#", 0, 9, 1, value -> {}).keepInvalidText())
                    .limit(3)
                    .toList();
        });
        AtomicBoolean closed = new AtomicBoolean();
        EventQueue.invokeLater(() -> {
            Box form = Box.createVerticalBox();
            fields.forEach(form::add);
            form.add(Box.createVerticalStrut(300));
            FormDialog.showDialog(null, "Invalid", form, textOf(fields.get(0)));
            closed.set(true);
        });
        for (NumberSpinner field : fields) {
            robot.waitFor("the field has the focus", textOf(field)::isFocusOwner);
            robot.pressKeys(KeyEvent.VK_X);
            robot.pressKeys(KeyEvent.VK_TAB);
        }
        Window dialog = callOnEdt(() -> SwingUtilities.getWindowAncestor(fields.get(0)));
        robot.waitFor(
                "the notes",
                () -> ComponentFinder.findAll(dialog, JToolTip.class).count() == fields.size());
        robot.pressKeys(KeyEvent.VK_ESCAPE);
        robot.waitFor("the dialog is closed", closed::get);
    }

    @Test
    void aFormThatIsWrongStaysAndTheFieldToCorrectGetsTheFocus() {
        List<JTextField> fields = callOnEdt(() -> {
            Theme.LIGHT.install();
            return List.of(new JTextField("5", 12), new JTextField("3", 12));
        });
        JTextField until = fields.get(1);
        AtomicBoolean accepted = new AtomicBoolean();
        EventQueue.invokeLater(() -> {
            Box form = Box.createVerticalBox();
            fields.forEach(form::add);
            accepted.set(FormDialog.showDialog(
                    null,
                    "Times",
                    form,
                    fields.get(0),
                    () -> until.getText().startsWith("3")
                            ? Optional.of(new FormDialog.FormProblem("Until must be after From", until))
                            : Optional.empty()));
        });
        robot.waitFor("the first field has the focus", fields.get(0)::isFocusOwner);
        Window dialog = callOnEdt(() -> SwingUtilities.getWindowAncestor(until));
        robot.pressKeys(KeyEvent.VK_ENTER);
        robot.waitFor("the warning", () -> dialog.getOwnedWindows().length > 0 && !dialog.isFocused());
        assertTrue(callOnEdt(dialog::isShowing));
        robot.pressKeys(KeyEvent.VK_ENTER);
        robot.waitFor("the field to correct has the focus", until::isFocusOwner);
        robot.pressKeys(KeyEvent.VK_HOME);
        robot.pressKeys(KeyEvent.VK_9);
        robot.waitFor("the corrected text", () -> until.getText().equals("93"));
        robot.pressKeys(KeyEvent.VK_ENTER);
        robot.waitFor("the form is accepted", accepted::get);
    }

    @Test
    void aTextIsSelectedWhenTheKeyboardReachesItsFieldAndNotWhenTheMouseDoes() {
        List<JTextField> fields = callOnEdt(() -> {
            Theme.LIGHT.install();
            return List.of(new JTextField("Empty room", 12), new JTextField("A description", 12));
        });
        JTextField name = fields.get(0);
        JTextField description = fields.get(1);
        EventQueue.invokeLater(() -> {
            Box form = Box.createVerticalBox();
            fields.forEach(form::add);
            FormDialog.showDialog(null, "Names", form, name);
        });
        robot.waitFor("the first field is selected", () -> "Empty room".equals(name.getSelectedText()));
        Window dialog = callOnEdt(() -> SwingUtilities.getWindowAncestor(name));
        robot.pressKeys(KeyEvent.VK_TAB);
        robot.waitFor("the second field is selected", () -> "A description".equals(description.getSelectedText()));
        assertEquals(0, callOnEdt(description::getCaretPosition), "the start of a long text shows");
        assertNull(callOnEdt(name::getSelectedText));
        robot.pressKeys(KeyEvent.VK_X);
        robot.waitFor("the typed text replaces it", () -> "x".equals(description.getText()));
        robot.click(name, 20, name.getHeight() / 2.0, InputEvent.BUTTON1_DOWN_MASK);
        robot.waitFor("the first field has the focus", name::isFocusOwner);
        assertNull(callOnEdt(name::getSelectedText));
        robot.pressKeys(KeyEvent.VK_ESCAPE);
        robot.waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    private static JTextField textOf(NumberSpinner field) {
        return ((JSpinner.DefaultEditor) field.getEditor()).getTextField();
    }

    private static boolean isWhole(Component part) {
        return ((JComponent) part).getVisibleRect().getSize().equals(part.getSize());
    }
}
