package faultline.gui.action;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeChoice;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.beans.PropertyChangeListener;

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
        preferences.set(Preference.THEME, choice);
        show(choice.theme());
    }

    private void followDesktop() {
        if (preferences.get(Preference.THEME) == ThemeChoice.DESKTOP) {
            show(ThemeChoice.DESKTOP.theme());
        }
    }

    private void show(Theme theme) {
        theme.install();
        updateAction();
        canvas.setPalette(theme.palette());
        WindowRefresh.refreshAll(1);
    }

    /** Shows the theme that the action switches to. */
    private void updateAction() {
        darkAction.setOn(Theme.current() == Theme.DARK);
        darkAction.withIcon(Theme.current() == Theme.DARK ? Glyph.SUN : Glyph.MOON);
    }
}
