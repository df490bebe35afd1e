package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;

/** Limits packed dialogs to the screen, so that their buttons stay visible. */
public final class ScreenFit {

    /** Room for the title bar and the borders that a window manager adds, pixels. */
    private static final Dimension DECORATION = new Dimension(16, 48);

    private ScreenFit() {}

    /** Packs a window and reduces its size to that of the screen. */
    public static void pack(Window window) {
        window.pack();
        if (!GraphicsEnvironment.isHeadless()) {
            Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
            window.setSize(limit(window.getSize(), screen.getSize()));
        }
    }

    /** Changes the size of a window by a factor, but shows its whole contents if the screen has room for them. */
    public static void resize(Window window, double factor) {
        Dimension preferred = window.getPreferredSize();
        Dimension wanted = new Dimension(
                Math.max(preferred.width, (int) Math.round(factor * window.getWidth())),
                Math.max(preferred.height, (int) Math.round(factor * window.getHeight())));
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        window.setSize(limit(wanted, screen.getSize()));
    }

    static Dimension limit(Dimension size, Dimension screen) {
        return new Dimension(
                Math.min(size.width, screen.width - DECORATION.width),
                Math.min(size.height, screen.height - DECORATION.height));
    }
}
