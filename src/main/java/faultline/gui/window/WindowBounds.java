package faultline.gui.window;

import faultline.gui.settings.WindowPreferences;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import javax.swing.JFrame;

/** Restores and stores the bounds of the window and its dividers, within the current screen. */
final class WindowBounds {

    private static final Dimension DEFAULT_SIZE = new Dimension(1360, 880);
    private static final Dimension MIN_SIZE = new Dimension(1024, 600);

    private final JFrame window;
    private final MainPanel mainPanel;
    private final WindowPreferences preferences;

    WindowBounds(JFrame window, MainPanel area, WindowPreferences preferences) {
        this.window = window;
        this.mainPanel = area;
        this.preferences = preferences;
    }

    /** Sets the bounds before the window is shown. */
    void restore() {
        window.setMinimumSize(MIN_SIZE);
        window.setSize(DEFAULT_SIZE);
        window.setLocationByPlatform(true);
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        preferences.bounds().filter(screen::intersects).ifPresent(window::setBounds);
        window.setSize(Math.min(window.getWidth(), screen.width), Math.min(window.getHeight(), screen.height));
        restoreDivider();
        preferences.dockHeight().ifPresent(mainPanel::setDockHeight);
        preferences
                .chartWidth()
                .ifPresent(width -> mainPanel.instruments().split().place(size -> width));
        mainPanel.setDockShown(preferences.isDockShown());
    }

    /** Places the divider again now that the window's insets are known. */
    void onWindowOpened() {
        restoreDivider();
    }

    private void restoreDivider() {
        window.validate();
        mainPanel.setPanelWidth(
                preferences.panelWidth().orElse(mainPanel.controlPanel().defaultWidth()));
    }

    /** Stores the bounds for the next window. */
    void save() {
        preferences.setBounds(window.getBounds());
        preferences.setPanelWidth(mainPanel.controlPanel().getWidth());
        preferences.setDock(
                mainPanel.instruments().isVisible(),
                mainPanel.dockHeight(),
                mainPanel.instruments().split().getDividerLocation());
    }
}
