package faultline.gui.theme;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.EnumSet;
import java.util.Set;

/** A line around a component that has gained the focus by keyboard. */
public final class FocusRing extends FocusAdapter {

    private static final Set<FocusEvent.Cause> KEYBOARD_CAUSES = EnumSet.of(
            FocusEvent.Cause.TRAVERSAL,
            FocusEvent.Cause.TRAVERSAL_FORWARD,
            FocusEvent.Cause.TRAVERSAL_BACKWARD,
            FocusEvent.Cause.TRAVERSAL_UP,
            FocusEvent.Cause.TRAVERSAL_DOWN);

    private final Component component;
    private boolean shown;

    /** Creates a ring for a component, which must call {@link #paint} after it has painted itself. */
    public FocusRing(Component component) {
        this.component = component;
        component.addFocusListener(this);
    }

    @Override
    public void focusGained(FocusEvent event) {
        setShown(KEYBOARD_CAUSES.contains(event.getCause()));
    }

    @Override
    public void focusLost(FocusEvent event) {
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
                g.setStroke(Antialiasing.roundStroke(2));
                g.draw(Antialiasing.roundedRectangle(1, 1, component.getWidth() - 2, component.getHeight() - 2));
            });
        }
    }
}
