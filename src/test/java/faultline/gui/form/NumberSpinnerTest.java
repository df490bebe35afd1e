package faultline.gui.form;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.theme.Theme;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import javax.swing.JFormattedTextField;
import javax.swing.JTextField;
import javax.swing.event.ChangeListener;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class NumberSpinnerTest {

    private final List<Double> reported = new ArrayList<>();
    private NumberSpinner spinner;

    @BeforeEach
    void make() {
        spinner = callOnEdt(() -> {
            Theme.LIGHT.install();
            return new NumberSpinner("0.00##", 0.01, 100, 0.05, reported::add).withName("robot.speed");
        });
    }

    @Test
    void updatingFromTheWorldNotifiesNobody() {
        runOnEdt(() -> spinner.setWorldValue(0.8));
        assertEquals("0.80", callOnEdt(() -> spinner.textField().getText()));
        assertEquals(List.of(), reported);
    }

    @Test
    void aUserChangeIsReportedAlsoAfterAnUpdateThatHasFailed() {
        runOnEdt(() -> {
            ChangeListener failing = event -> {
                throw new IllegalStateException("broken listener");
            };
            spinner.addChangeListener(failing);
            assertThrows(IllegalStateException.class, () -> spinner.setWorldValue(0.8));
            spinner.removeChangeListener(failing);
        });
        commit("1.25");
        assertEquals(List.of(1.25), reported);
    }

    @Test
    void anotherLimitKeepsWhatIsTypedAndTheCaret() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            JFormattedTextField text = spinner.textField();
            text.setText("12.5");
            text.select(1, 2);
            spinner.setMax(50);
            assertEquals("12.5", text.getText());
            assertEquals("2", text.getSelectedText());
            assertTrue(spinner.isEdited());
            assertTrue(text.isEditValid());
            spinner.setMax(5);
            assertEquals("12.5", text.getText());
            assertFalse(text.isEditValid());
            text.setText("4.5");
            assertTrue(spinner.commitPendingEdit());
        });
        assertEquals(List.of(4.5), reported);
    }

    @Test
    void aUserChangeIsReportedOnce() {
        commit("1,25");
        assertEquals(List.of(1.25), reported);
        assertEquals("1.25", callOnEdt(() -> spinner.textField().getText()));
    }

    @Test
    void aDigitThatFollowsTheFocusAtOnceReplacesTheNumber() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            JTextField text = spinner.textField();
            focus();
            text.replaceSelection("7");
            assertEquals("7", text.getText());
        });
    }

    /** Does what the field does when it gets the focus: it notifies the listeners, then formats its value. */
    private void focus() {
        JFormattedTextField text = spinner.textField();
        for (FocusListener listener : text.getFocusListeners()) {
            listener.focusGained(new FocusEvent(text, FocusEvent.FOCUS_GAINED));
        }
        text.setValue(text.getValue());
    }

    @Test
    void theNumberIsNotSelectedWithoutTheFocus() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            focus();
            JFormattedTextField text = spinner.textField();
            assertEquals("0.80", text.getSelectedText());
            for (FocusListener listener : text.getFocusListeners()) {
                listener.focusLost(new FocusEvent(text, FocusEvent.FOCUS_LOST));
            }
            text.setValue(text.getValue());
            assertNull(text.getSelectedText());
        });
    }

    @Test
    void aNumberThatChangesWhileItIsSelectedStaysSelected() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            JTextField text = spinner.textField();
            focus();
            spinner.setWorldValue(12.5);
            assertEquals("12.50", text.getSelectedText());
            text.select(1, 2);
            spinner.setWorldValue(3);
            assertNull(text.getSelectedText());
        });
    }

    @Test
    void anEnteredNumberIsSelectedSoThatTheNextOneReplacesIt() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            JFormattedTextField text = spinner.textField();
            focus();
            text.replaceSelection("1.5");
            text.getActionMap()
                    .get(JTextField.notifyAction)
                    .actionPerformed(new ActionEvent(text, ActionEvent.ACTION_PERFORMED, ""));
            assertEquals("1.50", text.getSelectedText());
            text.replaceSelection("2");
            assertEquals("2", text.getText());
        });
        assertEquals(List.of(1.5), reported);
    }

    @Test
    void aFieldThatDoesNotApplyIsNoInvalidOne() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            spinner.textField().setText("");
            assertFalse(spinner.commitValidEdit(), "an empty field");
            spinner.setEnabled(false);
            assertTrue(spinner.commitValidEdit(), "an empty field that does not apply");
        });
        assertEquals(List.of(), reported);
    }

    @Test
    void aNumberBeyondTheLimitsIsNotTaken() {
        runOnEdt(() -> spinner.setWorldValue(0.8));
        runOnEdt(() -> {
            spinner.textField().setText("500");
            assertFalse(spinner.textField().isEditValid(), "the outline shows it while it is typed");
            assertThrows(ParseException.class, spinner.textField()::commitEdit);
        });
        assertEquals(List.of(), reported);
        assertEquals(0.8, callOnEdt(spinner::doubleValue));
    }

    @Test
    void aNumberThatIsNotEditedKeepsTheDecimalsThatAreNotShown() {
        runOnEdt(() -> {
            spinner.setWorldValue(1.512345678);
            assertFalse(spinner.commitPendingEdit(), "not edited");
            spinner.textField().setText("2");
            spinner.textField().setText("1.5123");
            assertFalse(spinner.commitPendingEdit(), "the text from before");
        });
        assertEquals(1.512345678, callOnEdt(spinner::doubleValue));
        assertEquals(List.of(), reported);
    }

    @Test
    void theWorldMayHaveANumberThatTheUserMayNotGive() {
        runOnEdt(() -> spinner.setWorldValue(250));
        assertEquals("250.00", callOnEdt(() -> spinner.textField().getText()));
    }

    /** Other limits are those of another scenario: they are no change by the user. */
    @Test
    void otherLimitsAreReportedToNobodyAndKeepANumberAboveThem() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            spinner.setLimits(0.02, 0.3, 0.9);
            assertEquals("0.90", spinner.textField().getText());
            assertEquals("0.02 to 0.3", spinner.limitsText());
            assertFalse(spinner.commitPendingEdit(), "not edited");
        });
        assertEquals(List.of(), reported);
        runOnEdt(() -> spinner.setValue(spinner.getPreviousValue()));
        assertEquals(List.of(0.3), reported, "an arrow leads within the limits");
        commit("0.25");
        assertEquals(List.of(0.3, 0.25), reported);
    }

    @Test
    void anotherUpperLimitIsReportedToNobodyAndKeepsANumberAboveIt() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            spinner.setMax(0.5);
            assertEquals("0.80", spinner.textField().getText());
            assertEquals("0.01 to 0.5", spinner.limitsText());
            assertFalse(spinner.commitPendingEdit(), "not edited");
        });
        assertEquals(List.of(), reported);
        commit("0.4");
        assertEquals(List.of(0.4), reported);
    }

    @Test
    void anUpwardArrowGoesAStepUp() {
        runOnEdt(() -> spinner.setWorldValue(0.8));
        runOnEdt(() -> spinner.setValue(spinner.getNextValue()));
        assertEquals(0.85, reported.get(0), 1e-12);
    }

    /** A probability from 0 to 1, as typed numbers: the steps of doubles would end at 0.9500000000000004. */
    @Test
    void heldArrowsReachTheLimitsWithoutRoundingErrors() {
        NumberSpinner share = callOnEdt(() -> new NumberSpinner("0.00##", 0, 1, 0.05, value -> {}));
        runOnEdt(() -> share.setWorldValue(0.5));
        assertEquals(1.0, hold(share, NumberSpinner::getNextValue));
        assertEquals(0.0, hold(share, NumberSpinner::getPreviousValue));
        runOnEdt(() -> share.setWorldValue(0.31));
        assertEquals(0.36, callOnEdt(share::getNextValue));
        runOnEdt(() -> share.setWorldValue(0.98));
        assertEquals(1.0, callOnEdt(share::getNextValue), "a step beyond the limit leads to it");
    }

    @Test
    void anArrowLeadsANumberBeyondTheLimitsOnlyBack() {
        NumberSpinner share = callOnEdt(() -> new NumberSpinner("0.00##", 0, 1, 0.05, value -> {}));
        runOnEdt(() -> share.setWorldValue(7));
        assertNull(callOnEdt(share::getNextValue));
        assertEquals(1.0, callOnEdt(share::getPreviousValue));
    }

    /** Presses an arrow until it has no effect, and returns the number. */
    private static double hold(NumberSpinner spinner, Function<NumberSpinner, Object> arrow) {
        return callOnEdt(() -> {
            for (Object next = arrow.apply(spinner); next != null; next = arrow.apply(spinner)) {
                spinner.setValue(next);
            }
            return spinner.doubleValue();
        });
    }

    private void commit(String text) {
        runOnEdt(() -> {
            spinner.textField().setText(text);
            try {
                spinner.textField().commitEdit();
            } catch (ParseException refused) {
                throw new AssertionError(refused);
            }
        });
    }

    @Test
    void noNumberShowsNothingAndIsNotWrong() {
        runOnEdt(() -> {
            spinner.setWorldValue(0.8);
            spinner.setWorldValue(Double.NaN);
            assertEquals("", spinner.textField().getText());
            assertTrue(spinner.textField().isEditValid());
            spinner.setWorldValue(0.8);
            assertEquals("0.80", spinner.textField().getText());
        });
        assertEquals(List.of(), reported);
    }

    @Test
    void theFieldIsAsWideAsItsNumber() {
        runOnEdt(() -> {
            spinner.withColumns(5);
            for (double value : new double[] {0.8, 2.0543, 99.9999, 0.8}) {
                spinner.setWorldValue(value);
                for (Dimension size : List.of(spinner.getPreferredSize(), spinner.getMinimumSize())) {
                    spinner.setSize(size);
                    spinner.doLayout();
                    spinner.getEditor().doLayout();
                    JTextField text = spinner.textField();
                    int room = text.getWidth() - text.getInsets().left - text.getInsets().right;
                    int needed = text.getFontMetrics(text.getFont()).stringWidth(text.getText());
                    assertTrue(needed <= room, text.getText() + " needs " + needed + " pixels and has " + room);
                }
            }
        });
    }
}
