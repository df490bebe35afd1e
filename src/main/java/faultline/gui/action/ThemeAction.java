package faultline.gui.action;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeChoice;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.beans.PropertyChangeListener;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** Switches between the light and the dark theme, or follows the desktop. */
public final class ThemeAction {

    private final SimulationCanvas canvas;
    private final WindowPreferences preferences;
    private final PropertyChangeListener desktopListener = event -> EventQueue.invokeLater(this::followDesktop);
    private final UiAction darkAction = UiAction.toggle(
            "dark", Theme.current() == Theme.DARK, on -> choose(on ? ThemeChoice.DARK : ThemeChoice.LIGHT));

    public ThemeAction(SimulationCanvas canvas, WindowPreferences preferences) {
        this.canvas = canvas;
        this.preferences = preferences;
        updateAction();
        Toolkit.getDefaultToolkit().addPropertyChangeListener(ThemeChoice.DESKTOP_PROPERTY, desktopListener);
    }

    /** Follows the desktop no longer. */
    public void close() {
        Toolkit.getDefaultToolkit().removePropertyChangeListener(ThemeChoice.DESKTOP_PROPERTY, desktopListener);
    }

    public UiAction action() {
        return darkAction;
    }

    /** Stores a choice and shows its theme. */
    public void choose(ThemeChoice choice) {
        preferences.setThemeChoice(choice);
        show(choice.theme());
    }

    private void followDesktop() {
        if (preferences.themeChoice() == ThemeChoice.DESKTOP) {
            show(ThemeChoice.DESKTOP.theme());
        }
    }

    private void show(Theme theme) {
        theme.install();
        updateAction();
        canvas.setPalette(theme.palette());
        Stream.of(Window.getWindows()).filter(ThemeAction::mayShow).forEach(ThemeAction::update);
    }

    /** Returns whether a window shows or is a dialog that may show again; closed menus keep windows, too. */
    private static boolean mayShow(Window window) {
        return window.isShowing() || window instanceof JDialog && window.isDisplayable();
    }

    /** Updates the menus, which are mostly closed, in an event of their own, so that neither event takes long. */
    private static void update(Window window) {
        if (window instanceof JFrame frame) {
            SwingUtilities.updateComponentTreeUI(frame.getContentPane());
            SwingUtilities.updateComponentTreeUI(frame.getGlassPane());
            EventQueue.invokeLater(() -> SwingUtilities.updateComponentTreeUI(frame.getJMenuBar()));
        } else {
            SwingUtilities.updateComponentTreeUI(window);
        }
    }

    /** Shows the theme that the action switches to. */
    private void updateAction() {
        darkAction.setOn(Theme.current() == Theme.DARK);
        darkAction.withIcon(Theme.current() == Theme.DARK ? Glyph.SUN : Glyph.MOON);
    }
}
