package faultline.gui.theme;

import faultline.paint.surface.Palette;
import javax.swing.UIManager;

/** Light or dark. */
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

    /**
     * The theme that is installed.
     *
     * @return light where none is
     */
    public static Theme current() {
        return UIManager.get(DEFAULTS_KEY) instanceof Theme theme ? theme : LIGHT;
    }

    /**
     * The colours of controls now. Painting asks anew each time, so that a switch of themes shows at once.
     *
     * @return the installed theme's
     */
    public static ThemeColours currentColours() {
        return current().colours;
    }

    /** Makes this the theme of all components made or updated from now on. */
    public void install() {
        FlatLook.install(this);
        UIManager.put(DEFAULTS_KEY, this);
    }

    /**
     * The colours of controls.
     *
     * @return this theme's
     */
    public ThemeColours colours() {
        return colours;
    }

    /**
     * The colours of the canvas.
     *
     * @return this theme's
     */
    public Palette palette() {
        return palette;
    }

    /**
     * The other theme.
     *
     * @return dark for light, light for dark
     */
    public Theme opposite() {
        return this == LIGHT ? DARK : LIGHT;
    }
}
