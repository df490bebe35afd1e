package faultline.gui.theme;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Insets;
import javax.swing.border.AbstractBorder;

/** Padding around a group of controls, with a line at one edge in the colour of the current theme. */
public final class SeparatorBorder extends AbstractBorder {

    private final boolean above;
    private final Insets padding;

    private SeparatorBorder(boolean above, Insets padding) {
        this.above = above;
        this.padding = padding;
    }

    /** Returns a border with a line along the upper edge and the given padding in pixels. */
    public static SeparatorBorder above(int top, int side, int bottom) {
        return new SeparatorBorder(true, new Insets(top + 1, side, bottom, side));
    }

    /** Returns a border with a line along the lower edge and the given padding in pixels. */
    public static SeparatorBorder below(int top, int side, int bottom) {
        return new SeparatorBorder(false, new Insets(top, side, bottom + 1, side));
    }

    @Override
    public void paintBorder(Component component, Graphics graphics, int x, int y, int width, int height) {
        graphics.setColor(Theme.currentColours().line());
        graphics.fillRect(x, above ? y : y + height - 1, width, 1);
    }

    @Override
    public Insets getBorderInsets(Component component, Insets insets) {
        insets.set(padding.top, padding.left, padding.bottom, padding.right);
        return insets;
    }
}
