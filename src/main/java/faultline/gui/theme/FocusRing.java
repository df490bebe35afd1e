package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Insets;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.EnumSet;
import java.util.Set;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.border.AbstractBorder;

/**
 * A line around a component that has gained the focus by keyboard. It is shown again when a menu or another window
 * returns the focus.
 */
public final class FocusRing extends FocusAdapter {

    private static final Set<FocusEvent.Cause> KEYBOARD_CAUSES = EnumSet.of(
            FocusEvent.Cause.TRAVERSAL,
            FocusEvent.Cause.TRAVERSAL_FORWARD,
            FocusEvent.Cause.TRAVERSAL_BACKWARD,
            FocusEvent.Cause.TRAVERSAL_UP,
            FocusEvent.Cause.TRAVERSAL_DOWN);

    private final Component component;
    private boolean shown;
    /** Whether the ring was shown when the component lost the focus for a while. */
    private boolean suspended;

    /** Creates a ring for a component, which must call {@link #paint} after it has painted itself. */
    public FocusRing(Component component) {
        this.component = component;
        component.addFocusListener(this);
    }

    @Override
    public void focusGained(FocusEvent event) {
        boolean returned = suspended && event.getCause() != FocusEvent.Cause.MOUSE_EVENT;
        suspended = false;
        setShown(returned || KEYBOARD_CAUSES.contains(event.getCause()));
    }

    @Override
    public void focusLost(FocusEvent event) {
        suspended = shown && event.isTemporary();
        setShown(false);
    }

    private void setShown(boolean show) {
        shown = show;
        component.repaint();
    }

    /** Paints the ring if it is visible. */
    public void paint(Graphics graphics) {
        if (shown) {
            Antialiasing.paint(graphics, g -> {
                g.setColor(Theme.currentColours().accent());
                g.setStroke(DrawContext.solidStroke(2));
                g.draw(Antialiasing.roundedRectangle(1, 1, component.getWidth() - 2, component.getHeight() - 2));
            });
        }
    }

    /**
     * The border of a scroll pane, in the accent colour while what it shows has the focus. A list or table without a
     * selection shows the focus in no other place.
     */
    public static final class FocusBorder extends AbstractBorder {

        private static final int WIDTH = 2;

        private final boolean lined;

        /** Creates a border that shows a thin line without the focus if {@code lined} is true, or else nothing. */
        public FocusBorder(boolean lined) {
            this.lined = lined;
        }

        @Override
        public void paintBorder(Component component, Graphics graphics, int x, int y, int width, int height) {
            if (component instanceof JScrollPane pane) {
                ThemeColours colours = Theme.currentColours();
                if (isFocused(pane.getViewport())) {
                    paintBand(graphics, colours.accent(), x, y, width, height);
                } else {
                    paintGround(pane, graphics, x, y, width, height);
                    if (lined) {
                        paintLine(graphics, colours.line(), x, y, width, height);
                    }
                }
            }
        }

        /** Continues the backgrounds of the headings and of the content. */
        private static void paintGround(JScrollPane pane, Graphics graphics, int x, int y, int width, int height) {
            paintBand(graphics, background(pane.getViewport()), x, y, width, height);
            if (pane.getColumnHeader() != null) {
                int headings = WIDTH + pane.getColumnHeader().getHeight();
                graphics.setColor(background(pane.getColumnHeader()));
                graphics.fillRect(x, y, width, WIDTH);
                graphics.fillRect(x, y, WIDTH, headings);
                graphics.fillRect(x + width - WIDTH, y, WIDTH, headings);
            }
        }

        private static void paintBand(Graphics graphics, Color colour, int x, int y, int width, int height) {
            for (int i = 0; i < WIDTH; i++) {
                paintLine(graphics, colour, x + i, y + i, width - 2 * i, height - 2 * i);
            }
        }

        private static void paintLine(Graphics graphics, Color colour, int x, int y, int width, int height) {
            graphics.setColor(colour);
            graphics.drawRect(x, y, width - 1, height - 1);
        }

        private static Color background(JViewport viewport) {
            return viewport.getView() == null
                    ? viewport.getBackground()
                    : viewport.getView().getBackground();
        }

        private static boolean isFocused(JViewport viewport) {
            return viewport.getView() != null && viewport.getView().isFocusOwner();
        }

        @Override
        public Insets getBorderInsets(Component pane, Insets insets) {
            insets.set(WIDTH, WIDTH, WIDTH, WIDTH);
            return insets;
        }
    }
}
