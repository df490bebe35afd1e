package faultline.gui.theme;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import javax.swing.AbstractButton;
import javax.swing.ButtonModel;
import javax.swing.JToolBar;

/** What a button of either kind looks like behind its text and icon. */
public final class ButtonFace {

    /** The client property of the one button that stands out in the accent. */
    public static final String PRIMARY = "faultline.primary";

    private static final int SELECTED_ALPHA = 50;

    private ButtonFace() {
    }

    /**
     * Whether a button is the one that stands out.
     *
     * @param button any button
     * @return true where its property says so
     */
    static boolean isPrimary(AbstractButton button) {
        return Boolean.TRUE.equals(button.getClientProperty(PRIMARY));
    }

    static void paint(Graphics graphics, AbstractButton button) {
        Smooth.paint(graphics, g -> {
            Shape box = Smooth.box(0, 0, button.getWidth(), button.getHeight());
            fill(g, box, button);
            outline(g, box, button);
        });
    }

    private static void fill(Graphics2D g, Shape box, AbstractButton button) {
        Color ground = ground(button);
        if (ground.getAlpha() > 0) {
            g.setColor(ground);
            g.fill(box);
        }
    }

    private static Color ground(AbstractButton button) {
        ThemeColours colours = Theme.now();
        ButtonModel model = button.getModel();
        if (isPrimary(button)) {
            return mixed(colours.accent(), colours.text(), model.isArmed() ? 0.25 : model.isRollover() ? 0.12 : 0);
        }
        if (model.isSelected()) {
            return ThemeColours.translucent(colours.accent(), SELECTED_ALPHA);
        }
        if (model.isArmed() && model.isPressed()) {
            return colours.pressed();
        }
        if (model.isRollover() && button.isEnabled()) {
            return colours.hover();
        }
        return isOnBar(button) ? new Color(0, true) : colours.field();
    }

    private static Color mixed(Color one, Color other, double share) {
        return new Color(mixed(one.getRed(), other.getRed(), share), mixed(one.getGreen(), other.getGreen(), share),
                mixed(one.getBlue(), other.getBlue(), share));
    }

    private static int mixed(int one, int other, double share) {
        return (int) Math.round(one + share * (other - one));
    }

    private static void outline(Graphics2D g, Shape box, AbstractButton button) {
        ThemeColours colours = Theme.now();
        if (button.hasFocus()) {
            g.setColor(isPrimary(button) ? colours.text() : colours.accent());
            g.setStroke(Smooth.line(1.8));
            g.draw(box);
        } else if (button.isSelected()) {
            g.setColor(colours.accent());
            g.draw(box);
        } else if (!isOnBar(button) && !isPrimary(button)) {
            g.setColor(button.isEnabled() ? colours.border() : colours.line());
            g.draw(box);
        }
    }

    private static boolean isOnBar(AbstractButton button) {
        return button.getParent() instanceof JToolBar;
    }
}
