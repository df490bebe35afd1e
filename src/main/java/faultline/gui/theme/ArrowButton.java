package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.geom.Path2D;
import javax.swing.BorderFactory;
import javax.swing.JButton;

/** The small arrow button of spinners and combo boxes. */
final class ArrowButton extends JButton {

    private final int down;

    private ArrowButton(int down) {
        this.down = down;
        setBorder(BorderFactory.createEmptyBorder());
        setFocusable(false);
        setPreferredSize(new Dimension(18, 11));
    }

    static ArrowButton up() {
        return new ArrowButton(-1);
    }

    static ArrowButton down() {
        return new ArrowButton(1);
    }

    @Override
    public void paint(Graphics graphics) {
        ThemeColours colours = Theme.currentColours();
        Antialiasing.paint(graphics, g -> {
            g.setColor(
                    getModel().isPressed()
                            ? colours.pressed()
                            : getModel().isRollover() ? colours.hover() : colours.field());
            g.fillRect(0, 0, getWidth(), getHeight());
            g.setColor(isEnabled() ? colours.muted() : colours.line());
            g.setStroke(DrawContext.solidStroke(1.5));
            g.draw(chevron(getWidth() / 2.0, getHeight() / 2.0));
        });
    }

    private Path2D chevron(double x, double y) {
        Path2D chevron = new Path2D.Double();
        chevron.moveTo(x - 3.5, y - 1.8 * down);
        chevron.lineTo(x, y + 1.8 * down);
        chevron.lineTo(x + 3.5, y - 1.8 * down);
        return chevron;
    }
}
