package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import javax.swing.JTextField;

/** Finds the colour of the outline of fields. */
public final class FieldOutline {

    private FieldOutline() {}

    /** Returns the colour in the middle of the left edge. */
    public static Color colour(JTextField field) {
        return callOnEdt(() -> {
            field.setSize(120, 30);
            BufferedImage image = new BufferedImage(120, 30, BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = image.createGraphics();
            field.paint(graphics);
            graphics.dispose();
            return new Color(image.getRGB(0, 15), true);
        });
    }
}
