package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics;
import java.awt.Insets;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Area;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.border.AbstractBorder;

/**
 * The rounded outline of a field, in the accent colour if the focus is inside, in the warning colour if the text is
 * invalid.
 */
public final class FieldBorder extends AbstractBorder {

    /** The key of the property of a field whose text is invalid. */
    private static final String INVALID = "faultline.invalid";

    private final int vertical;
    private final int horizontal;

    /** Creates a border with vertical and horizontal padding in pixels. */
    FieldBorder(int vertical, int horizontal) {
        this.vertical = vertical;
        this.horizontal = horizontal;
    }

    /** Shows whether the text of a field that is not formatted is valid. */
    public static void setValid(JTextField field, boolean valid) {
        field.putClientProperty(INVALID, valid ? null : true);
        field.repaint();
    }

    @Override
    public void paintBorder(Component field, Graphics graphics, int x, int y, int width, int height) {
        Antialiasing.paint(graphics, g -> {
            Shape outline = Antialiasing.roundedRectangle(x, y, width, height);
            Area corners = new Area(new Rectangle(x, y, width, height));
            corners.subtract(new Area(outline));
            g.setColor(backgroundColour(field));
            g.fill(corners);
            g.setColor(outlineColour(field));
            g.setStroke(DrawContext.solidStroke(isFocused(field) ? 1.8 : 1));
            g.draw(outline);
        });
    }

    private static Color backgroundColour(Component field) {
        Container parent = field.getParent();
        return parent == null ? Theme.currentColours().background() : parent.getBackground();
    }

    private static Color outlineColour(Component field) {
        ThemeColours colours = Theme.currentColours();
        if (!isValid(field)) {
            return colours.warning();
        }
        return isFocused(field) ? colours.accent() : field.isEnabled() ? colours.border() : colours.line();
    }

    private static boolean isValid(Component field) {
        if (field instanceof JSpinner spinner && spinner.getEditor() instanceof JSpinner.DefaultEditor editor) {
            return editor.getTextField().isEditValid();
        }
        if (field instanceof JFormattedTextField text) {
            return text.isEditValid();
        }
        return !(field instanceof JTextField text) || text.getClientProperty(INVALID) == null;
    }

    private static boolean isFocused(Component field) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return owner != null
                && (owner == field || field instanceof Container container && container.isAncestorOf(owner));
    }

    @Override
    public Insets getBorderInsets(Component field, Insets insets) {
        insets.set(vertical, horizontal, vertical, horizontal);
        return insets;
    }
}
