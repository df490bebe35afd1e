package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import javax.swing.JDialog;
import javax.swing.JRootPane;

/**
 * Limits packed dialogs to the screen, so that their buttons stay visible. A dialog that the user has not resized is
 * packed again when its text changes its size.
 */
public final class ScreenFit {

    /** Room for the title bar and the borders that a window manager adds, pixels. */
    private static final Dimension DECORATION = new Dimension(16, 48);

    private static final String PACKED_SIZE = "faultline.packedSize";

    private ScreenFit() {}

    /** Packs a dialog and reduces its size to that of the screen. */
    public static void pack(JDialog dialog) {
        dialog.pack();
        if (!GraphicsEnvironment.isHeadless()) {
            Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
            dialog.setSize(limit(dialog.getSize(), screen.getSize()));
        }
        dialog.validate();
        // Without the borders, whose widths are known only after the window manager has added them.
        dialog.getRootPane().putClientProperty(PACKED_SIZE, dialog.getRootPane().getSize());
    }

    /**
     * Packs a dialog again whose size is that of {@link #pack}. Changes another size by a factor, but shows the whole
     * contents if the screen has room for them.
     */
    public static void resize(JDialog dialog, double factor) {
        JRootPane contents = dialog.getRootPane();
        if (contents.getSize().equals(contents.getClientProperty(PACKED_SIZE))) {
            pack(dialog);
            return;
        }
        Dimension preferred = dialog.getPreferredSize();
        Dimension wanted = new Dimension(
                Math.max(preferred.width, (int) Math.round(factor * dialog.getWidth())),
                Math.max(preferred.height, (int) Math.round(factor * dialog.getHeight())));
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        dialog.setSize(limit(wanted, screen.getSize()));
    }

    static Dimension limit(Dimension size, Dimension screen) {
        return new Dimension(
                Math.min(size.width, screen.width - DECORATION.width),
                Math.min(size.height, screen.height - DECORATION.height));
    }
}
