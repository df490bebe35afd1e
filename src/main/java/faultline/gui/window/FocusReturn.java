package faultline.gui.window;

import java.awt.Component;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;

/**
 * Gives the focus to a substitute when a window gains it again, if what had the focus before cannot have it any more:
 * keys would have no effect.
 */
final class FocusReturn extends WindowAdapter {

    private final Component substitute;
    /** What had the focus when the window lost it, null before. */
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
            substitute.requestFocusInWindow();
        }
    }
}
