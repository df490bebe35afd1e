package faultline.gui.window;

import java.awt.Component;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;

/**
 * Repaints a window that is activated on a scaled screen. When another window uncovers it, the toolkit rounds the
 * uncovered rectangle down to whole units, so that a line of pixels of the other window's border may remain.
 */
final class ExposedRepaint extends WindowAdapter {

    private final Component contents;

    ExposedRepaint(Component contents) {
        this.contents = contents;
    }

    @Override
    public void windowActivated(WindowEvent event) {
        if (!contents.getGraphicsConfiguration().getDefaultTransform().isIdentity()) {
            contents.repaint();
        }
    }
}
