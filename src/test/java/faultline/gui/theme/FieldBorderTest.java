package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
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
        assertEquals(Theme.LIGHT.colours().border().getRGB(), outline(field));
        runOnEdt(() -> FieldBorder.setValid(field, false));
        assertEquals(Theme.LIGHT.colours().warning().getRGB(), outline(field));
        runOnEdt(() -> FieldBorder.setValid(field, true));
        assertEquals(Theme.LIGHT.colours().border().getRGB(), outline(field));
    }

    /** Returns the colour in the middle of the left edge. */
    private static int outline(JTextField field) {
        return callOnEdt(() -> {
            field.setSize(120, 30);
            BufferedImage image = new BufferedImage(120, 30, BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = image.createGraphics();
            field.paint(graphics);
            graphics.dispose();
            return image.getRGB(0, 15);
        });
    }
}
