package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import javax.swing.AbstractButton;
import javax.swing.ButtonModel;
import javax.swing.JButton;
import javax.swing.JToolBar;

/** Paints the background of buttons. */
public final class ButtonPainter {

    /** The client property of a button in the accent colour. */
    public static final String PRIMARY = "faultline.primary";

    private static final int SELECTED_ALPHA = 50;

    private ButtonPainter() {}

    /** Returns whether a button has the property {@link #PRIMARY}. */
    static boolean isPrimary(AbstractButton button) {
        return Boolean.TRUE.equals(button.getClientProperty(PRIMARY));
    }

    static void paint(Graphics graphics, AbstractButton button) {
        Antialiasing.paint(graphics, g -> {
            Shape box = Antialiasing.roundedRectangle(0, 0, button.getWidth(), button.getHeight());
            paintBackground(g, box, button);
            paintOutline(g, box, button);
        });
    }

    private static void paintBackground(Graphics2D g, Shape box, AbstractButton button) {
        Color ground = backgroundColour(button);
        if (ground.getAlpha() > 0) {
            g.setColor(ground);
            g.fill(box);
        }
    }

    private static Color backgroundColour(AbstractButton button) {
        ThemeColours colours = Theme.currentColours();
        ButtonModel model = button.getModel();
        if (isPrimary(button)) {
            return blend(colours.accent(), colours.text(), model.isArmed() ? 0.25 : model.isRollover() ? 0.12 : 0);
        }
        if (model.isSelected()) {
            return Palette.withAlpha(colours.accent(), SELECTED_ALPHA);
        }
        if (model.isArmed() && model.isPressed()) {
            return colours.pressed();
        }
        if (model.isRollover() && button.isEnabled()) {
            return colours.hover();
        }
        return isOnToolBar(button) ? new Color(0, true) : colours.field();
    }

    private static Color blend(Color one, Color other, double share) {
        return new Color(
                blend(one.getRed(), other.getRed(), share),
                blend(one.getGreen(), other.getGreen(), share),
                blend(one.getBlue(), other.getBlue(), share));
    }

    private static int blend(int one, int other, double share) {
        return (int) Math.round(one + share * (other - one));
    }

    private static void paintOutline(Graphics2D g, Shape box, AbstractButton button) {
        ThemeColours colours = Theme.currentColours();
        if (button.hasFocus()) {
            g.setColor(isPrimary(button) ? colours.text() : colours.accent());
            g.setStroke(DrawContext.solidStroke(1.8));
            g.draw(box);
        } else if (button.isSelected() || isDefault(button)) {
            g.setColor(colours.accent());
            g.draw(box);
        } else if (!isOnToolBar(button) && !isPrimary(button)) {
            g.setColor(button.isEnabled() ? colours.border() : colours.line());
            g.draw(box);
        }
    }

    /** Returns whether Enter presses a button that does not have the focus. */
    private static boolean isDefault(AbstractButton button) {
        return button.isEnabled() && button instanceof JButton pressed && pressed.isDefaultButton();
    }

    private static boolean isOnToolBar(AbstractButton button) {
        return button.getParent() instanceof JToolBar;
    }
}
