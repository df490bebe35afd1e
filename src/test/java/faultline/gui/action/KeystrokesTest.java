package faultline.gui.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class KeystrokesTest {

    @ParameterizedTest
    @CsvSource({
        "SPACE, true",
        "PERIOD, true",
        "shift P, true",
        "1, true",
        "typed ., true",
        "ctrl O, false",
        "alt F, false",
        "F1, false",
        "shift F1, false",
        "ctrl shift S, false"
    })
    void aKeystrokeProducesTextUnlessAModifierOtherThanShiftIsPressedOrItIsAFunctionKey(String stroke, boolean types) {
        assertEquals(types, Keystrokes.producesText(KeyStroke.getKeyStroke(stroke)));
    }

    @Test
    void aTextNamesTheModifierOfThePlatformsMenus() {
        String tour = "Undo with Ctrl+Z and restart with Ctrl+R";
        assertEquals(tour, Keystrokes.withModifier(tour, InputEvent.CTRL_DOWN_MASK));
        assertEquals("Undo with ⌘+Z and restart with ⌘+R", Keystrokes.withModifier(tour, InputEvent.META_DOWN_MASK));
    }

    @Test
    void aStrokeIsTypedIntoATextAndNotIntoAButton() {
        KeyStroke space = Keystrokes.unmodified(KeyEvent.VK_SPACE);
        assertTrue(Keystrokes.isTypedInto(new JTextField(), space));
        assertFalse(Keystrokes.isTypedInto(new JButton(), space));
        assertFalse(Keystrokes.isTypedInto(
                new JTextField(), KeyStroke.getKeyStroke(KeyEvent.VK_O, InputEvent.CTRL_DOWN_MASK)));
        assertFalse(Keystrokes.isTypedInto(null, space));
    }

    @Test
    void aDigitIsTypedIntoAListWhichLeavesLettersToTheMenus() {
        KeyStroke digit = Keystrokes.unmodified(KeyEvent.VK_3);
        Stream.of(new JList<>(), new JTable(), new JComboBox<>())
                .forEach(list -> assertTrue(Keystrokes.isTypedInto(list, digit), list::toString));
        assertFalse(Keystrokes.isTypedInto(new JButton(), digit));
        assertFalse(Keystrokes.isTypedInto(null, digit));
        assertFalse(Keystrokes.isTypedInto(new JList<>(), Keystrokes.unmodified(KeyEvent.VK_N)));
        assertFalse(Keystrokes.isTypedInto(new JList<>(), Keystrokes.menuShortcut(KeyEvent.VK_0)));
    }

    @AfterEach
    void useEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void keyNamesAreInTheLanguageOfTheWindow() {
        assertEquals("Space", Keystrokes.toText(Keystrokes.unmodified(KeyEvent.VK_SPACE)));
        Messages.setLanguage(Language.POLISH);
        assertEquals("Spacja", Keystrokes.toText(Keystrokes.unmodified(KeyEvent.VK_SPACE)));
        assertEquals("Ctrl+Shift+S", Keystrokes.toText(KeyStroke.getKeyStroke("ctrl shift S")));
        assertEquals("F1", Keystrokes.toText(Keystrokes.unmodified(KeyEvent.VK_F1)));
        assertEquals("7", Keystrokes.toText(Keystrokes.unmodified(KeyEvent.VK_7)));
    }

    @Test
    void aKeystrokeOfACharacterIsShownAsTheCharacter() {
        assertEquals(".", Keystrokes.toText(Keystrokes.character('.')));
        assertEquals("Ctrl++", Keystrokes.toText(Keystrokes.menuCharacter('+')));
        assertTrue(Keystrokes.isMenuCharacter(Keystrokes.menuCharacter('+')));
        assertFalse(Keystrokes.isMenuCharacter(Keystrokes.character('.')));
    }
}
