package faultline.gui.theme;

import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.util.Locale;

/** The user's choice of a theme. */
public enum ThemeChoice {
    /** Always light. */
    LIGHT,
    /** Always dark. */
    DARK,
    /** The theme of the desktop; light if the desktop does not publish its theme. */
    DESKTOP;

    /** The desktop property with the name of the theme, which GNOME, Xfce, MATE and others publish. */
    public static final String DESKTOP_PROPERTY = "gnome.Net/ThemeName";

    /** Returns the theme that this choice means now. */
    public Theme theme() {
        if (this == DESKTOP) {
            return GraphicsEnvironment.isHeadless()
                    ? Theme.LIGHT
                    : themeOfDesktop(Toolkit.getDefaultToolkit().getDesktopProperty(DESKTOP_PROPERTY));
        }
        return this == DARK ? Theme.DARK : Theme.LIGHT;
    }

    /** Returns the theme that suits a desktop theme, given its name, such as Adwaita-dark; null if it has none. */
    static Theme themeOfDesktop(Object name) {
        return name instanceof String text && text.toLowerCase(Locale.ROOT).contains("dark") ? Theme.DARK : Theme.LIGHT;
    }
}
