package faultline.gui.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.InputEvent;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;

class KeyBindingsTest {

    @Test
    void theMenuModifierIsThatOfThePlatform() {
        assertEquals(KeyStroke.getKeyStroke("meta C"), KeyBindings.stroke("menu C", InputEvent.META_DOWN_MASK));
        assertEquals(KeyStroke.getKeyStroke("ctrl C"), KeyBindings.stroke("menu C", InputEvent.CTRL_DOWN_MASK));
        assertEquals(KeyStroke.getKeyStroke("shift F10"), KeyBindings.stroke("shift F10", InputEvent.META_DOWN_MASK));
    }
}
