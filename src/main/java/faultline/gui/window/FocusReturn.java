package faultline.gui.window;

import java.awt.Component;
import java.awt.event.FocusEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;

/**
 * Moves the focus to a substitute when a window gains it again and the component that had it before can no longer have
 * it, because keys would otherwise have no effect.
 */
final class FocusReturn extends WindowAdapter {

    private final Component substitute;
    /** The component that had the focus when the window lost it, null before. */
    private Component lastFocused;

    FocusReturn(Component substitute) {
        this.substitute = substitute;
    }

    @Override
    public void windowLostFocus(WindowEvent event) {
        lastFocused = event.getWindow().getMostRecentFocusOwner();
    }

    @Override
    public void windowGainedFocus(WindowEvent event) {
        if (lastFocused != null && !(lastFocused.isShowing() && lastFocused.isEnabled())) {
            // The cause shows where the focus is.
            substitute.requestFocusInWindow(FocusEvent.Cause.TRAVERSAL);
        }
    }
}
