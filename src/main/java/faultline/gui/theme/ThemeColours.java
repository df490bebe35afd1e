package faultline.gui.theme;

import java.awt.Color;
import javax.swing.plaf.ColorUIResource;

/**
 * The colours of controls. Text has a contrast ratio of at least 4.5:1 on all backgrounds, and the outlines and states
 * of controls at least 3:1, as defined by WCAG; separators carry no meaning and have less.
 *
 * @param background the background of windows, bars and panels
 * @param field the background of fields and lists
 * @param text text
 * @param muted units, column headings and values that do not apply
 * @param line separators
 * @param border outlines of fields, boxes and tracks
 * @param accent selected, focused and measured items
 * @param onAccent text and icons on the accent colour
 * @param hover the background of a control under the cursor
 * @param pressed the background of a pressed control
 * @param warning warning icons and outlines
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

    /** Returns a UI resource, so that components replace it with the colour of another theme. */
    private static Color rgb(int rgb) {
        return new ColorUIResource(rgb);
    }
}
