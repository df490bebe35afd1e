package faultline.gui.theme;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Insets;
import javax.swing.border.AbstractBorder;

/**
 * Room round a group of controls, and a ruling at one edge in the colour of the theme that is installed when it is
 * painted.
 */
public final class SeparatorBorder extends AbstractBorder {

    private final boolean above;
    private final Insets padding;

    private SeparatorBorder(boolean above, Insets room) {
        this.above = above;
        this.padding = room;
    }

    /**
     * A ruling along the upper edge.
     *
     * @param top room below the ruling, pixels
     * @param side room at either side, pixels
     * @param bottom room at the bottom, pixels
     * @return the border
     */
    public static SeparatorBorder above(int top, int side, int bottom) {
        return new SeparatorBorder(true, new Insets(top + 1, side, bottom, side));
    }

    /**
     * A ruling along the lower edge.
     *
     * @param top room at the top, pixels
     * @param side room at either side, pixels
     * @param bottom room above the ruling, pixels
     * @return the border
     */
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
