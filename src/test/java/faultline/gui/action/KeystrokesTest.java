package faultline.gui.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.text.Language;
import faultline.gui.text.Texts;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JButton;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class KeystrokesTest {

    @ParameterizedTest
    @CsvSource({"SPACE, true", "PERIOD, true", "shift P, true", "1, true", "typed ., true", "ctrl O, false", "alt F, false", "F1, false",
            "shift F1, false",
        "ctrl shift S, false"})
    void aStrokeTypesUnlessAModifierOtherThanShiftIsHeldOrItIsAFunctionKey(String stroke, boolean types) {
        assertEquals(types, Keystrokes.types(KeyStroke.getKeyStroke(stroke)));
    }

    @Test
    void aStrokeIsTypedIntoATextAndNotIntoAButton() {
        KeyStroke space = Keystrokes.plain(KeyEvent.VK_SPACE);
        assertTrue(Keystrokes.isTypedInto(new JTextField(), space));
        assertFalse(Keystrokes.isTypedInto(new JButton(), space));
        assertFalse(Keystrokes.isTypedInto(new JTextField(), KeyStroke.getKeyStroke(KeyEvent.VK_O, InputEvent.CTRL_DOWN_MASK)));
        assertFalse(Keystrokes.isTypedInto(null, space));
    }

    @AfterEach
    void speakEnglish() {
        Texts.speak(Language.ENGLISH);
    }

    @Test
    void keysAreCalledAsTheWindowSpeaks() {
        assertEquals("Space", Keystrokes.text(Keystrokes.plain(KeyEvent.VK_SPACE)));
        Texts.speak(Language.POLISH);
        assertEquals("Spacja", Keystrokes.text(Keystrokes.plain(KeyEvent.VK_SPACE)));
        assertEquals("Ctrl+Shift+S", Keystrokes.text(KeyStroke.getKeyStroke("ctrl shift S")));
        assertEquals("F1", Keystrokes.text(Keystrokes.plain(KeyEvent.VK_F1)));
        assertEquals("7", Keystrokes.text(Keystrokes.plain(KeyEvent.VK_7)));
    }

    @Test
    void signsAreWrittenAsSigns() {
        assertEquals(".", Keystrokes.text(Keystrokes.sign('.')));
        assertEquals("Ctrl++", Keystrokes.text(Keystrokes.menuSign('+')));
        assertTrue(Keystrokes.isMenuSign(Keystrokes.menuSign('+')));
        assertFalse(Keystrokes.isMenuSign(Keystrokes.sign('.')));
    }
}
