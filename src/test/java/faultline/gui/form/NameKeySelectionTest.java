package faultline.gui.form;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.text.FaultText;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.sensor.FaultKind;
import javax.swing.JComboBox;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class NameKeySelectionTest {

    private final JComboBox<FaultKind> kinds = callOnEdt(() -> new JComboBox<>(FaultKind.values()));
    private long millis = 5000;

    NameKeySelectionTest() {
        NameKeySelection.install(kinds, FaultText::nameOf, () -> millis);
    }

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    /** Returns what is selected after some letters have been typed, each in a tenth of a second. */
    private FaultKind type(FaultKind before, String letters) {
        return callOnEdt(() -> {
            kinds.setSelectedItem(before);
            millis += 2000;
            for (char letter : letters.toCharArray()) {
                millis += 100;
                kinds.selectWithKeyChar(letter);
            }
            return (FaultKind) kinds.getSelectedItem();
        });
    }

    @Test
    void aCompleteNameSelectsItsEntryAlsoIfAnotherOneBeginsWithIt() {
        for (FaultKind before : FaultKind.values()) {
            for (FaultKind kind : FaultKind.values()) {
                assertEquals(kind, type(before, FaultText.nameOf(kind)), before + " " + kind);
            }
        }
    }

    @Test
    void theFirstLetterSelectsTheNextEntryAsEachRepetitionDoes() {
        assertEquals(FaultKind.STUCK_AT_LAST, type(FaultKind.STUCK, "s"));
        assertEquals(FaultKind.SCALE, type(FaultKind.STUCK, "ss"));
        assertEquals(FaultKind.DROPOUT, type(FaultKind.DROPOUT, "x"));
    }

    @Test
    void theEntryThatWasSelectedStaysIfItBeginsWithTheLetters() {
        assertEquals(FaultKind.STUCK, type(FaultKind.STUCK, "stu"));
        assertEquals(FaultKind.STUCK_AT_LAST, type(FaultKind.STUCK_AT_LAST, "STU"));
        assertEquals(FaultKind.STUCK, type(FaultKind.OFF, "stu"));
    }

    @Test
    void lettersAfterASecondOrAfterAnotherSelectionAreNewOnes() {
        assertEquals(FaultKind.DROPOUT, type(FaultKind.OFF, "d"));
        millis += 1000;
        assertEquals(FaultKind.SHORT_RANGE, callOnEdt(() -> {
            kinds.setSelectedItem(FaultKind.DELAYED);
            kinds.selectWithKeyChar('s');
            return kinds.getSelectedItem();
        }));
        assertEquals(FaultKind.BIAS, callOnEdt(() -> {
            kinds.setSelectedItem(FaultKind.STUCK);
            kinds.selectWithKeyChar('b');
            return kinds.getSelectedItem();
        }));
    }

    /** The names of constants are English. */
    @Test
    void theNamesAreThoseOfTheLanguage() {
        Messages.setLanguage(Language.POLISH);
        for (FaultKind kind : FaultKind.values()) {
            assertEquals(kind, type(FaultKind.OFF, FaultText.nameOf(kind)));
        }
    }
}
