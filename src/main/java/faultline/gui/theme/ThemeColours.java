package faultline.gui.theme;

import java.awt.Color;
import javax.swing.plaf.ColorUIResource;

/**
 * The colours of controls. Text stands out from all grounds at 4.5:1 at least, and what shows where a control is or how
 * it stands at 3:1, by the WCAG's contrast ratio; rulings between groups carry no meaning and are paler.
 *
 * @param background of windows, bars and panels
 * @param field ground of what can be typed in or chosen from
 * @param text texts
 * @param muted units, headings of columns, values that do not apply
 * @param line rulings between groups
 * @param border outlines of fields, boxes and tracks
 * @param accent what is chosen, focused or measured
 * @param onAccent texts and icons on the accent
 * @param hover ground of a control under the mouse
 * @param pressed ground of a control that is held down
 * @param warning icons and outlines of what is wrong
 */
public record ThemeColours(
        Color background,
        Color field,
        Color text,
        Color muted,
        Color line,
        Color border,
        Color accent,
        Color onAccent,
        Color hover,
        Color pressed,
        Color warning) {

    static final ThemeColours LIGHT = new ThemeColours(
            rgb(0xF3F4F6),
            rgb(0xFFFFFF),
            rgb(0x1F2430),
            rgb(0x5A6574),
            rgb(0xD5DAE1),
            rgb(0x7F8A9A),
            rgb(0x0B6BCB),
            rgb(0xFFFFFF),
            rgb(0xE5E9EF),
            rgb(0xD8DEE6),
            rgb(0xC24E00));

    static final ThemeColours DARK = new ThemeColours(
            rgb(0x1E2127),
            rgb(0x15181C),
            rgb(0xE4E7EB),
            rgb(0x98A2B3),
            rgb(0x3A404A),
            rgb(0x6F7989),
            rgb(0x4C9BE8),
            rgb(0x0B1A28),
            rgb(0x2B3039),
            rgb(0x363D48),
            rgb(0xFF7B6E));

    /** Resources, so that components exchange them for another theme's. */
    private static Color rgb(int rgb) {
        return new ColorUIResource(rgb);
    }

    /**
     * A colour made translucent.
     *
     * @param colour the colour
     * @param alpha from 0, invisible, to 255, opaque
     * @return the same colour otherwise
     */
    public static Color translucent(Color colour, int alpha) {
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
    }
}
