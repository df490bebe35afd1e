package faultline.gui.window;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import javax.swing.JFrame;

/** Where the window and its panes are: as they were left last, as far as today's screen has room for that. */
final class WindowPlace {

    private static final Dimension USUAL = new Dimension(1360, 880);
    private static final Dimension LEAST = new Dimension(1024, 600);

    private final JFrame window;
    private final WorkArea area;
    private final WindowMemory memory;

    WindowPlace(JFrame window, WorkArea area, WindowMemory memory) {
        this.window = window;
        this.area = area;
        this.memory = memory;
    }

    /** Puts all in its place before the window shows. */
    void restore() {
        window.setMinimumSize(LEAST);
        window.setSize(USUAL);
        window.setLocationByPlatform(true);
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        memory.bounds().filter(screen::intersects).ifPresent(window::setBounds);
        window.setSize(Math.min(window.getWidth(), screen.width), Math.min(window.getHeight(), screen.height));
        placeDivider();
        memory.dockHeight().ifPresent(area::setDockHeight);
        memory.chartWidth().ifPresent(width -> area.instruments().split().place(size -> width));
        area.setDockShown(memory.isDockShown());
    }

    /** The window shows: only now is it known how much of it its frame takes. */
    void opened() {
        placeDivider();
    }

    private void placeDivider() {
        window.validate();
        area.setPanelWidth(memory.panelWidth().orElse(area.panel().usualWidth()));
    }

    /** Remembers all for the next window. */
    void keep() {
        memory.keepBounds(window.getBounds());
        memory.keepPanelWidth(area.panel().getWidth());
        memory.keepDock(area.instruments().isVisible(), area.dockHeight(), area.instruments().split().getDividerLocation());
    }
}
