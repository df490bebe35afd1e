package faultline.gui.window;

import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.Theme;
import faultline.paint.surface.DrawContext;
import java.awt.Graphics;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/** A glass pane with a ring around the control that the tour explains. Mouse and keys reach what is below it. */
final class TourMarker extends JComponent {

    private static final int MARGIN = 3;
    private static final float WIDTH = 3;

    /** Null for none. */
    private transient JComponent target;

    /** Marks a control, or none if it is null. */
    void setTarget(JComponent control) {
        target = control;
        setVisible(control != null);
        repaint();
    }

    @Override
    public boolean contains(int x, int y) {
        return false;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        if (target == null || !target.isShowing()) {
            return;
        }
        Rectangle ring = SwingUtilities.convertRectangle(target, target.getVisibleRect(), this);
        ring.grow(MARGIN, MARGIN);
        Rectangle edge = ring.intersection(new Rectangle(1, 1, getWidth() - 2, getHeight() - 2));
        Antialiasing.paint(graphics, g -> {
            g.setColor(Theme.currentColours().accent());
            g.setStroke(DrawContext.solidStroke(WIDTH));
            g.draw(Antialiasing.roundedRectangle(edge.x, edge.y, edge.width, edge.height));
        });
    }
}
