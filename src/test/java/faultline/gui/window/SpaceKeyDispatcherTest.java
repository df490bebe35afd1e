package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.gui.form.EnteredTextField;
import faultline.gui.form.NumberSpinner;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Which component gets Space and Enter in the main window. */
class SpaceKeyDispatcherTest {

    private final List<String> log = new ArrayList<>();
    private JPanel window;

    @BeforeEach
    void createWindow() {
        window = callOnEdt(JPanel::new);
    }

    private boolean press(Component focused, int key, char character) {
        runOnEdt(() -> window.add(focused));
        return pressIn(focused, key, character);
    }

    private boolean pressIn(Component focused, int key, char character) {
        return callOnEdt(() -> {
            SpaceKeyDispatcher dispatcher = new SpaceKeyDispatcher(window, () -> log.add("run"));
            boolean pressed =
                    dispatcher.dispatchKeyEvent(new KeyEvent(focused, KeyEvent.KEY_PRESSED, 0, 0, key, character));
            boolean typed = dispatcher.dispatchKeyEvent(
                    new KeyEvent(focused, KeyEvent.KEY_TYPED, 0, 0, KeyEvent.VK_UNDEFINED, character));
            boolean released =
                    dispatcher.dispatchKeyEvent(new KeyEvent(focused, KeyEvent.KEY_RELEASED, 0, 0, key, character));
            assertEquals(pressed, typed);
            assertEquals(pressed, released);
            return pressed;
        });
    }

    @Test
    void spaceStartsTheRunInsteadOfPressingTheFocusedButton() {
        JButton inject = callOnEdt(() -> new JButton("Inject"));
        inject.addActionListener(event -> log.add("inject"));
        assertEquals(true, press(inject, KeyEvent.VK_SPACE, ' '));
        assertEquals(true, press(callOnEdt(JCheckBox::new), KeyEvent.VK_SPACE, ' '));
        assertEquals(true, press(callOnEdt(JTabbedPane::new), KeyEvent.VK_SPACE, ' '));
        assertEquals(true, press(callOnEdt(() -> new JComboBox<String>()), KeyEvent.VK_SPACE, ' '));
        assertEquals(List.of("run", "run", "run", "run"), log);
    }

    @Test
    void spaceStartsTheRunInsteadOfSelectingARow() {
        assertEquals(true, press(callOnEdt(() -> new JList<String>()), KeyEvent.VK_SPACE, ' '));
        assertEquals(true, press(callOnEdt(() -> new JTable()), KeyEvent.VK_SPACE, ' '));
        assertEquals(List.of("run", "run"), log);
    }

    /** Sends a key to a list at a time, milliseconds; returns whether its press and its character reach the list. */
    private List<Boolean> type(SpaceKeyDispatcher dispatcher, JList<?> list, long when, char character) {
        int key = KeyEvent.getExtendedKeyCodeForChar(character);
        return callOnEdt(() -> {
            boolean pressed =
                    dispatcher.dispatchKeyEvent(new KeyEvent(list, KeyEvent.KEY_PRESSED, when, 0, key, character));
            boolean typed = dispatcher.dispatchKeyEvent(
                    new KeyEvent(list, KeyEvent.KEY_TYPED, when, 0, KeyEvent.VK_UNDEFINED, character));
            assertEquals(
                    pressed,
                    dispatcher.dispatchKeyEvent(new KeyEvent(list, KeyEvent.KEY_RELEASED, when, 0, key, character)));
            return List.of(!pressed, !typed);
        });
    }

    @Test
    void spaceIsALetterWhileAnEntryIsSelectedByItsLetters() {
        JList<String> list = callOnEdt(() -> new JList<>(new String[] {"big box", "desk", "big table"}));
        runOnEdt(() -> window.add(list));
        SpaceKeyDispatcher dispatcher = callOnEdt(() -> new SpaceKeyDispatcher(window, () -> log.add("run")));
        assertEquals(List.of(true, true), type(dispatcher, list, 5000, 'b'));
        assertEquals(List.of(true, true), type(dispatcher, list, 5900, 'i'));
        assertEquals(List.of(true, true), type(dispatcher, list, 6800, 'g'));
        assertEquals(List.of(false, true), type(dispatcher, list, 7700, ' '), "its press would end the selection");
        assertEquals(List.of(true, true), type(dispatcher, list, 8600, 't'));
        assertEquals(List.of(), log);
        assertEquals(List.of(false, false), type(dispatcher, list, 9700, ' '), "after a second");
        assertEquals(List.of("run"), log);
        type(dispatcher, list, 11_000, 'd');
        assertFalse(
                callOnEdt(() -> dispatcher.dispatchKeyEvent(new KeyEvent(
                        list, KeyEvent.KEY_PRESSED, 11_100, KeyEvent.CTRL_DOWN_MASK, KeyEvent.VK_SPACE, ' '))),
                "selects a row");
        type(dispatcher, list, 12_000, 'x');
        assertEquals(List.of(false, false), type(dispatcher, list, 12_100, ' '), "no entry begins like this");
        assertEquals(List.of("run", "run"), log);
    }

    @Test
    void spaceStartsTheRunInANumberFieldUnlessItsTextIsEdited() {
        NumberSpinner number = callOnEdt(() -> new NumberSpinner("0.0", 0, 9, 1, value -> {}));
        runOnEdt(() -> window.add(number));
        assertEquals(true, pressIn(number.textField(), KeyEvent.VK_SPACE, ' '));
        runOnEdt(() -> number.textField().setText("0."));
        assertEquals(false, pressIn(number.textField(), KeyEvent.VK_SPACE, ' '));
        assertEquals(List.of("run"), log);
    }

    @Test
    void spaceStartsTheRunInAFieldForAnIdAfterEnterHasAppliedIt() {
        EnteredTextField.IdField field =
                callOnEdt(() -> new EnteredTextField.IdField("obstacle.id", 8, (id, newId) -> Optional.empty()));
        runOnEdt(() -> {
            window.add(field);
            field.setId("desk");
            field.setText("table");
        });
        assertEquals(false, pressIn(field, KeyEvent.VK_SPACE, ' '));
        runOnEdt(field::postActionEvent);
        assertEquals("table", callOnEdt(field::getSelectedText));
        assertEquals(true, pressIn(field, KeyEvent.VK_SPACE, ' '));
        runOnEdt(() -> field.setCaretPosition(5));
        assertEquals(false, pressIn(field, KeyEvent.VK_SPACE, ' '), "an id may contain spaces");
        assertEquals(List.of("run"), log);
    }

    @Test
    void enterPressesTheFocusedButton() {
        JButton inject = callOnEdt(() -> new JButton("Inject"));
        inject.addActionListener(event -> log.add("inject"));
        assertEquals(true, press(inject, KeyEvent.VK_ENTER, '\n'));
        assertEquals(List.of("inject"), log);
    }

    @Test
    void textFieldsTablesAndOtherWindowsKeepTheirKeys() {
        assertEquals(false, press(callOnEdt(JTextField::new), KeyEvent.VK_SPACE, ' '));
        assertEquals(false, press(callOnEdt(JTextField::new), KeyEvent.VK_ENTER, '\n'));
        JTable table = callOnEdt(() -> new JTable());
        assertEquals(false, press(table, KeyEvent.VK_ENTER, '\n'));
        assertEquals(false, press(callOnEdt(table::getTableHeader), KeyEvent.VK_SPACE, ' '));
        JButton elsewhere = callOnEdt(() -> new JButton("OK"));
        runOnEdt(() -> {
            SpaceKeyDispatcher dispatcher = new SpaceKeyDispatcher(window, () -> log.add("run"));
            assertEquals(
                    false,
                    dispatcher.dispatchKeyEvent(
                            new KeyEvent(elsewhere, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_SPACE, ' ')));
        });
        assertEquals(List.of(), log);
    }
}
