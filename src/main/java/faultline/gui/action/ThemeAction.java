package faultline.gui.action;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Theme;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** Switches between the light and the dark theme. */
public final class ThemeAction {

    private final JFrame window;
    private final SimulationCanvas canvas;
    private final WindowPreferences preferences;
    private final UiAction darkAction =
            UiAction.toggle("dark", Theme.current() == Theme.DARK, on -> switchTo(on ? Theme.DARK : Theme.LIGHT));

    public ThemeAction(JFrame window, SimulationCanvas canvas, WindowPreferences preferences) {
        this.window = window;
        this.canvas = canvas;
        this.preferences = preferences;
        updateIcon();
    }

    public UiAction action() {
        return darkAction;
    }

    private void switchTo(Theme theme) {
        theme.install();
        updateIcon();
        canvas.setPalette(theme.palette());
        SwingUtilities.updateComponentTreeUI(window);
        preferences.setTheme(theme);
    }

    /** Shows the theme that the action switches to. */
    private void updateIcon() {
        darkAction.withIcon(Theme.current() == Theme.DARK ? Glyph.SUN : Glyph.MOON);
    }
}
