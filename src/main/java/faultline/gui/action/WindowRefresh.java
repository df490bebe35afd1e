package faultline.gui.action;

import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Window;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPopupMenu;
import javax.swing.JRootPane;
import javax.swing.JViewport;

/**
 * Refreshes a window after a change of theme, language or text size: look, texts, sizes and layout. The keyboard focus
 * and what scroll panes show stay. The work is divided into several events, so that none of them takes long.
 */
final class WindowRefresh {

    /** The number of components that are refreshed in one event. */
    private static final int MAX_COMPONENTS = 50;

    private final Window window;
    private final double growth;
    private final Component focusOwner;
    private final List<Runnable> events = new ArrayList<>();
    private final Map<JViewport, Double> scrolledShares = new LinkedHashMap<>();

    private WindowRefresh(Window window, double growth) {
        this.window = window;
        this.growth = growth;
        focusOwner = window.getMostRecentFocusOwner();
        rememberScrollPositions(window);
        Stream.of(window.getComponents()).forEach(this::addEvents);
        events.add(this::restore);
    }

    /** Refreshes all windows, given the new text size divided by the old one. */
    static void refreshAll(double growth) {
        Stream.of(Window.getWindows())
                .filter(WindowRefresh::mayShow)
                .map(window -> new WindowRefresh(window, growth))
                .forEach(refresh -> refresh.events.forEach(EventQueue::invokeLater));
    }

    /** Returns whether a window shows or is a dialog that may show again; closed menus keep windows, too. */
    private static boolean mayShow(Window window) {
        return window.isShowing() || window instanceof JDialog && window.isDisplayable();
    }

    private void rememberScrollPositions(Component part) {
        if (part instanceof JViewport viewport && viewport.getViewPosition().y > 0) {
            double share = (double) viewport.getViewPosition().y / viewport.getViewSize().height;
            scrolledShares.put(viewport, share);
        }
        RefreshSteps.childrenOf(part).forEach(this::rememberScrollPositions);
    }

    /** Adds one event for a small part of the window, or several for a large one. */
    private void addEvents(Component part) {
        if (count(part) <= MAX_COMPONENTS) {
            events.add(() -> {
                updateLook(part);
                runSteps(part);
            });
        } else {
            events.add(() -> updateOneLook(part));
            RefreshSteps.childrenOf(part).forEach(this::addEvents);
            events.add(() -> RefreshSteps.run(part));
        }
    }

    private static int count(Component part) {
        return 1
                + RefreshSteps.childrenOf(part).stream()
                        .mapToInt(WindowRefresh::count)
                        .sum();
    }

    private static void updateLook(Component part) {
        updateOneLook(part);
        RefreshSteps.childrenOf(part).forEach(WindowRefresh::updateLook);
    }

    private static void updateOneLook(Component part) {
        if (part instanceof JComponent component) {
            component.updateUI();
            JPopupMenu popup = component.getComponentPopupMenu();
            if (popup != null) {
                updateLook(popup);
            }
        }
    }

    /** Runs the steps of the parts of a component before its own, which may depend on their sizes. */
    private static void runSteps(Component part) {
        RefreshSteps.childrenOf(part).forEach(WindowRefresh::runSteps);
        RefreshSteps.run(part);
    }

    private void restore() {
        if (window instanceof JDialog dialog) {
            ScreenFit.resize(dialog, growth);
        }
        window.validate();
        scrolledShares.forEach((viewport, share) -> viewport.setViewPosition(
                new Point(viewport.getViewPosition().x, (int) Math.round(share * viewport.getViewSize().height))));
        // The root pane only has the focus for a menu, which gives it back itself.
        if (focusOwner != null && !(focusOwner instanceof JRootPane)) {
            focusOwner.requestFocusInWindow();
        }
        window.repaint();
    }
}
