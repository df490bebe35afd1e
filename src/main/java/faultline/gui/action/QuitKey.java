package faultline.gui.action;

import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import javax.swing.JComponent;
import javax.swing.JDialog;

/** Lets the key that quits the program work in a dialog that has no menu. */
public final class QuitKey {

    private QuitKey() {}

    /** Lets the key close the owner of a dialog, as if the user had closed that window. */
    public static void install(JDialog dialog) {
        Window owner = dialog.getOwner();
        dialog.getRootPane()
                .registerKeyboardAction(
                        event -> owner.dispatchEvent(new WindowEvent(owner, WindowEvent.WINDOW_CLOSING)),
                        Keystrokes.menuShortcut(KeyEvent.VK_Q),
                        JComponent.WHEN_IN_FOCUSED_WINDOW);
    }
}
