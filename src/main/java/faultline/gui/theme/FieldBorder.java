package faultline.gui.theme;

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
import javax.swing.border.AbstractBorder;

/**
 * The round outline of a field: in the accent while the focus is inside, in the warning colour while what is typed
 * cannot be taken.
 */
final class FieldBorder extends AbstractBorder {

    private final int vertical;
    private final int horizontal;

    /** A border with room inside, pixels above and below, and at either side. */
    FieldBorder(int vertical, int horizontal) {
        this.vertical = vertical;
        this.horizontal = horizontal;
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
            g.setStroke(Antialiasing.roundStroke(isFocused(field) ? 1.8 : 1));
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
        return !(field instanceof JFormattedTextField text) || text.isEditValid();
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
