package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class FieldBorderTest {

    @BeforeEach
    void install() {
        runOnEdt(Theme.LIGHT::install);
    }

    @Test
    void anInvalidTextHasAnOutlineInTheColourOfWarnings() {
        JTextField field = callOnEdt(() -> new JTextField("0.8..0.2"));
        assertEquals(Theme.LIGHT.colours().border(), FieldOutline.colour(field));
        runOnEdt(() -> FieldBorder.setValid(field, false));
        assertEquals(Theme.LIGHT.colours().warning(), FieldOutline.colour(field));
        runOnEdt(() -> FieldBorder.setValid(field, true));
        assertEquals(Theme.LIGHT.colours().border(), FieldOutline.colour(field));
    }
}
