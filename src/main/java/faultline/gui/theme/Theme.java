package faultline.gui.theme;

import faultline.paint.surface.Palette;
import javax.swing.UIManager;

/** The light and the dark theme. */
public enum Theme {
    /** Dark on light. */
    LIGHT(ThemeColours.LIGHT, Palette.LIGHT),
    /** Light on dark. */
    DARK(ThemeColours.DARK, Palette.DARK);

    private static final String DEFAULTS_KEY = "faultline.theme";

    private final ThemeColours colours;
    private final Palette palette;

    Theme(ThemeColours colours, Palette palette) {
        this.colours = colours;
        this.palette = palette;
    }

    /** Returns the installed theme, light if none is. */
    public static Theme current() {
        return UIManager.get(DEFAULTS_KEY) instanceof Theme theme ? theme : LIGHT;
    }

    /**
     * Returns the control colours of the installed theme. Components request them whenever they paint, so that a change
     * of the theme takes effect.
     */
    public static ThemeColours currentColours() {
        return current().colours;
    }

    /** Installs this theme for all components created or updated afterwards. */
    public void install() {
        FlatLook.install(this);
        UIManager.put(DEFAULTS_KEY, this);
    }

    /** Returns the colours of controls. */
    public ThemeColours colours() {
        return colours;
    }

    /** Returns the colours of the canvas. */
    public Palette palette() {
        return palette;
    }
}
