package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.geom.RoundRectangle2D;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JScrollBar;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicScrollBarUI;

/** A flat scroll bar: a rounded thumb without arrows. */
public final class FlatScrollBarUI extends BasicScrollBarUI {

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatScrollBarUI();
    }

    @Override
    protected JButton createDecreaseButton(int orientation) {
        return createZeroSizeButton();
    }

    @Override
    protected JButton createIncreaseButton(int orientation) {
        return createZeroSizeButton();
    }

    private static JButton createZeroSizeButton() {
        JButton button = new JButton();
        button.setFocusable(false);
        button.setPreferredSize(new Dimension());
        button.setMinimumSize(new Dimension());
        button.setMaximumSize(new Dimension());
        return button;
    }

    @Override
    protected void paintTrack(Graphics graphics, JComponent component, Rectangle track) {
        if (component.isOpaque()) {
            graphics.setColor(Theme.currentColours().background());
            graphics.fillRect(track.x, track.y, track.width, track.height);
        }
    }

    @Override
    protected void paintThumb(Graphics graphics, JComponent component, Rectangle thumb) {
        boolean upright = scrollbar.getOrientation() == JScrollBar.VERTICAL;
        int across = 3;
        int along = 2;
        Antialiasing.paint(graphics, g -> {
            g.setColor(
                    isThumbRollover() || isDragging
                            ? Theme.currentColours().muted()
                            : Theme.currentColours().border());
            int dx = upright ? across : along;
            int dy = upright ? along : across;
            g.fill(new RoundRectangle2D.Double(
                    thumb.x + dx, thumb.y + dy, thumb.width - 2 * dx, thumb.height - 2 * dy, 6, 6));
        });
    }
}
