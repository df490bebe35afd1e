package faultline.gui.window;

import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JFrame;

/** Restores and stores the bounds and the state of the window, and its dividers, within the current screen. */
final class WindowBounds {

    /** The size on screens that have room for it. */
    private static final Dimension DEFAULT_SIZE = new Dimension(1360, 880);
    /** The part of a larger screen that the window takes, and its largest size there. */
    private static final double SCREEN_SHARE = 0.9;

    private static final Dimension MAX_DEFAULT_SIZE = new Dimension(1920, 1200);
    private static final Dimension MIN_SIZE = new Dimension(1024, 600);
    /** The part of the title bar that must be on a screen, pixels. */
    private static final Dimension MIN_VISIBLE_TITLE = new Dimension(120, 20);

    private final JFrame window;
    private final MainPanel mainPanel;
    private final WindowPreferences preferences;
    /** Null until the window manager has reported the bounds. */
    private Rectangle confirmedBounds;
    /** Whether the window was opened maximised and has not been restored. */
    private boolean openedMaximised;

    WindowBounds(JFrame window, MainPanel mainPanel, WindowPreferences preferences) {
        this.window = window;
        this.mainPanel = mainPanel;
        this.preferences = preferences;
    }

    /** Sets the bounds before the window is shown. */
    void restore() {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        window.setMinimumSize(
                new Dimension(Math.min(MIN_SIZE.width, screen.width), Math.min(MIN_SIZE.height, screen.height)));
        Rectangle bounds = preferences
                .get(Preference.BOUNDS)
                .flatMap(stored -> onScreen(stored, screens()))
                .orElseGet(() -> centred(screen));
        window.setBounds(bounds);
        if (preferences.get(Preference.MAXIMISED)) {
            maximise(bounds);
        }
        window.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentMoved(ComponentEvent event) {
                confirm();
            }

            @Override
            public void componentResized(ComponentEvent event) {
                confirm();
            }
        });
        restoreDivider();
        preferences.get(Preference.DOCK_HEIGHT).ifPresent(mainPanel.dividers()::setDockHeight);
        preferences.get(Preference.LANES_HEIGHT).ifPresent(mainPanel.dividers()::setLanesHeight);
        preferences.get(Preference.CHART_WIDTH).ifPresent(mainPanel.instruments()::setChartWidth);
    }

    /**
     * Opens the window maximised. A window manager need not know other bounds of such a window, so they are set when
     * the user restores it.
     */
    private void maximise(Rectangle normalBounds) {
        window.setExtendedState(Frame.MAXIMIZED_BOTH);
        openedMaximised = true;
        window.addWindowStateListener(event -> {
            if (openedMaximised && event.getNewState() == Frame.NORMAL) {
                openedMaximised = false;
                window.setBounds(normalBounds);
            }
        });
    }

    /**
     * Returns the default bounds in the centre of the screen. An explicit location is needed: with one chosen by the
     * window manager, AWT may keep a wrong location, so that popups do not open and dialogs are off centre.
     */
    private static Rectangle centred(Rectangle screen) {
        int width = defaultLength(DEFAULT_SIZE.width, MAX_DEFAULT_SIZE.width, screen.width);
        int height = defaultLength(DEFAULT_SIZE.height, MAX_DEFAULT_SIZE.height, screen.height);
        return new Rectangle(
                screen.x + (screen.width - width) / 2, screen.y + (screen.height - height) / 2, width, height);
    }

    private static int defaultLength(int usual, int most, int available) {
        int share = (int) Math.min(most, SCREEN_SHARE * available);
        return Math.min(available, Math.max(usual, share));
    }

    private static Stream<Rectangle> screens() {
        return Stream.of(GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices())
                .map(device -> device.getDefaultConfiguration().getBounds());
    }

    /**
     * Returns bounds whose title bar is on a screen, empty for others. If they are larger than the screen, because they
     * were stored with another one, they are reduced to it.
     */
    static Optional<Rectangle> onScreen(Rectangle bounds, Stream<Rectangle> screens) {
        return screens.filter(screen -> isTitleOn(screen.intersection(bounds), bounds))
                .findFirst()
                .map(screen -> reduced(bounds, screen));
    }

    private static boolean isTitleOn(Rectangle visible, Rectangle bounds) {
        return visible.width >= MIN_VISIBLE_TITLE.width
                && visible.height >= MIN_VISIBLE_TITLE.height
                && visible.y == bounds.y;
    }

    private static Rectangle reduced(Rectangle bounds, Rectangle screen) {
        Rectangle reduced = new Rectangle(bounds);
        if (bounds.width > screen.width) {
            reduced.x = screen.x;
            reduced.width = screen.width;
        }
        if (bounds.height > screen.height) {
            reduced.y = screen.y;
            reduced.height = screen.height;
        }
        return reduced;
    }

    /** Keeps bounds that the window manager has reported for the visible window in its normal state. */
    private void confirm() {
        if (!openedMaximised && window.isShowing() && window.getExtendedState() == Frame.NORMAL) {
            confirmedBounds = window.getBounds();
        }
    }

    /** Places the divider again now that the window's insets are known. */
    void onWindowOpened() {
        restoreDivider();
    }

    private void restoreDivider() {
        window.validate();
        mainPanel
                .dividers()
                .setPanelWidth(preferences
                        .get(Preference.PANEL_WIDTH)
                        .orElse(mainPanel.controlPanel().defaultWidth()));
    }

    /** Stores the bounds for the next window. */
    void save() {
        if (confirmedBounds != null) {
            preferences.set(Preference.BOUNDS, Optional.of(confirmedBounds));
        }
        preferences.set(
                Preference.MAXIMISED, (window.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH);
        preferences.set(Preference.PANEL_WIDTH, Optional.of(mainPanel.dividers().panelWidth()));
        preferences.set(Preference.DOCK_HEIGHT, Optional.of(mainPanel.dividers().dockHeight()));
        preferences.set(Preference.LANES_HEIGHT, mainPanel.dividers().lanesHeight());
        mainPanel
                .instruments()
                .chosenChartWidth()
                .ifPresent(width -> preferences.set(Preference.CHART_WIDTH, Optional.of(width)));
    }
}
