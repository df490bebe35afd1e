package faultline.gui.theme;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JRootPane;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;

/**
 * Limits packed dialogs to the screen, so that their buttons stay visible and their fields scroll. A dialog that the
 * user has not resized is packed again when its text changes its size.
 */
public final class ScreenFit {

    /** Room for the title bar and the borders that a window manager adds, pixels. */
    private static final Dimension DECORATION = new Dimension(16, 48);

    private static final int WHEEL_STEP = 16;

    private static final String PACKED_SIZE = "faultline.packedSize";

    private ScreenFit() {}

    /** Packs a dialog and reduces its size to that of the screen. */
    public static void pack(JDialog dialog) {
        dialog.pack();
        if (!GraphicsEnvironment.isHeadless()) {
            Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
            dialog.setSize(fit(dialog.getSize(), screen.getSize(), new JScrollBar().getPreferredSize().width));
        }
        dialog.validate();
        // Without the borders, whose widths are known only after the window manager has added them.
        dialog.getRootPane().putClientProperty(PACKED_SIZE, dialog.getRootPane().getSize());
    }

    /**
     * Packs a visible dialog again whose size is that of {@link #pack}. Changes another size by a factor, but shows the
     * whole contents if the screen has room for them. Moves the dialog up and to the left as far as its lower right
     * corner is not on its screen.
     */
    public static void resize(JDialog dialog, double factor) {
        JRootPane contents = dialog.getRootPane();
        boolean packed = contents.getSize().equals(contents.getClientProperty(PACKED_SIZE));
        Dimension preferred = dialog.getPreferredSize();
        Dimension screen = GraphicsEnvironment.getLocalGraphicsEnvironment()
                .getMaximumWindowBounds()
                .getSize();
        Dimension size = packed
                ? fit(preferred, screen, new JScrollBar().getPreferredSize().width)
                : limit(
                        new Dimension(
                                Math.max(preferred.width, (int) Math.round(factor * dialog.getWidth())),
                                Math.max(preferred.height, (int) Math.round(factor * dialog.getHeight()))),
                        screen);
        // One change of the bounds: between two, a late event of the window manager could restore the size before them.
        dialog.setBounds(new Rectangle(locationOnScreen(dialog, size), size));
        dialog.validate();
        if (packed) {
            Insets borders = dialog.getInsets();
            contents.putClientProperty(
                    PACKED_SIZE,
                    new Dimension(
                            size.width - borders.left - borders.right, size.height - borders.top - borders.bottom));
        }
    }

    /** Returns the location of a dialog with a size, up and to the left as far as it would extend beyond its screen. */
    private static Point locationOnScreen(JDialog dialog, Dimension size) {
        Rectangle screen = dialog.getGraphicsConfiguration().getBounds();
        Insets panels = dialog.getToolkit().getScreenInsets(dialog.getGraphicsConfiguration());
        int right = screen.x + screen.width - panels.right;
        int bottom = screen.y + screen.height - panels.bottom;
        return new Point(
                Math.min(dialog.getX(), Math.max(screen.x + panels.left, right - size.width)),
                Math.min(dialog.getY(), Math.max(screen.y + panels.top, bottom - size.height)));
    }

    /** Returns a scroll pane without borders around the fields of a dialog, which shows the field with the focus. */
    public static JScrollPane scrolling(JComponent fields) {
        JScrollPane scroll = new JScrollPane(fields);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.getVerticalScrollBar().setUnitIncrement(WHEEL_STEP);
        showFocused(fields);
        return scroll;
    }

    private static void showFocused(Container fields) {
        for (Component part : fields.getComponents()) {
            if (part instanceof JComponent field) {
                field.addFocusListener(new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent event) {
                        // A text field would scroll only its own text.
                        ((JComponent) field.getParent()).scrollRectToVisible(field.getBounds());
                    }
                });
                showFocused(field);
            }
        }
    }

    /**
     * Limits a size to the screen. What is too high is wider by the vertical scroll bar, so that no other one appears.
     */
    static Dimension fit(Dimension size, Dimension screen, int bar) {
        Dimension limited = limit(size, screen);
        return limited.height == size.height ? limited : limit(new Dimension(size.width + bar, size.height), screen);
    }

    static Dimension limit(Dimension size, Dimension screen) {
        return new Dimension(
                Math.min(size.width, screen.width - DECORATION.width),
                Math.min(size.height, screen.height - DECORATION.height));
    }
}
