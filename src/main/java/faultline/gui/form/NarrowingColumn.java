package faultline.gui.form;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;

/** Sections that are laid out to the width of their viewport, and scroll sideways only below their minimum width. */
public final class NarrowingColumn extends JPanel implements Scrollable {

    /** The distance of one step of the wheel, pixels. */
    private static final int WHEEL_STEP = 16;

    /** The width of the viewport for which the sections have computed their heights, pixels. */
    private int viewportWidth;

    /** Creates a column with a border layout. */
    public NarrowingColumn() {
        super(new BorderLayout());
    }

    /** Returns the size for the present width of the viewport, on which the heights of the sections depend. */
    @Override
    public Dimension getPreferredSize() {
        int width = getParent() == null ? 0 : getParent().getWidth();
        if (width != viewportWidth) {
            viewportWidth = width;
            invalidateAll(this);
        }
        return super.getPreferredSize();
    }

    private static void invalidateAll(Container container) {
        container.invalidate();
        Stream.of(container.getComponents())
                .filter(JPanel.class::isInstance)
                .forEach(panel -> invalidateAll((JPanel) panel));
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return WHEEL_STEP;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return orientation == SwingConstants.VERTICAL ? visible.height : visible.width;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return getParent().getWidth() >= getMinimumSize().width;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent().getHeight() > getPreferredSize().height;
    }
}
