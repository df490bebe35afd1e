package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.plaf.UIResource;

/** The box of a check box. */
final class CheckBoxIcon implements Icon, UIResource {

    private static final int SIZE = 16;
    private static final int FOCUS_ALPHA = 110;

    @Override
    public int getIconWidth() {
        return SIZE;
    }

    @Override
    public int getIconHeight() {
        return SIZE;
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        AbstractButton button = (AbstractButton) component;
        Antialiasing.paint(graphics, g -> {
            g.translate(x, y);
            paintBox(g, button);
            if (button.isSelected()) {
                paintTick(g);
            }
        });
    }

    private static void paintBox(Graphics2D g, AbstractButton button) {
        ThemeColours colours = Theme.currentColours();
        Color on = button.isEnabled() ? colours.accent() : colours.muted();
        RoundRectangle2D box = new RoundRectangle2D.Double(0.5, 0.5, SIZE - 1, SIZE - 1, 6, 6);
        g.setColor(button.isSelected() ? on : button.getModel().isRollover() ? colours.hover() : colours.field());
        g.fill(box);
        g.setColor(button.isSelected() ? on : colours.border());
        g.draw(box);
        if (button.hasFocus()) {
            g.setColor(Palette.withAlpha(colours.accent(), FOCUS_ALPHA));
            g.setStroke(DrawContext.solidStroke(2));
            g.draw(new RoundRectangle2D.Double(-1, -1, SIZE + 2, SIZE + 2, 8, 8));
        }
    }

    private static void paintTick(Graphics2D g) {
        Path2D tick = new Path2D.Double();
        tick.moveTo(4, 8.2);
        tick.lineTo(7, 11.2);
        tick.lineTo(12, 5);
        g.setColor(Theme.currentColours().onAccent());
        g.setStroke(DrawContext.solidStroke(2));
        g.draw(tick);
    }
}
