package faultline.paint.surface;

import java.awt.Color;
import java.util.List;

/**
 * The colours of the charts and plans of figures. Obstacles, robot and path have the colours of print, which are paler
 * than those of the window. Series differ in lightness, dash pattern and marker, not in hue alone.
 *
 * @param palette the palette of scenes and of the chart's text and background
 * @param grid lines behind the data
 * @param series the series of lines and points, in order
 * @param classes the classes of the cells of a map, from the best class to the worst
 */
public record ChartStyle(Palette palette, Color grid, List<Color> series, List<Color> classes) {

    /** The size of the texts in a chart, except those of titles and axes, pixels. */
    public static final double TEXT_SIZE = 11;

    private static final double BAND_OPACITY = 0.2;

    /** For paper. */
    public static final ChartStyle LIGHT = new ChartStyle(
            new Palette(
                    false,
                    Color.WHITE,
                    Palette.LIGHT.grid(),
                    Palette.LIGHT.gridMajor(),
                    Palette.LIGHT.text(),
                    Palette.LIGHT.muted(),
                    Palette.LIGHT.accent(),
                    new Color(0xB8C0CB),
                    new Color(0x5A6676),
                    Palette.LIGHT.moving(),
                    Palette.LIGHT.movingOutline(),
                    new Color(0x56B4E9),
                    new Color(0x0B4F79),
                    new Color(0x009E73),
                    new Color(0xD55E00),
                    Palette.LIGHT.collision(),
                    Palette.LIGHT.reference(),
                    Palette.LIGHT.sensors()),
            new Color(0xE3E7EC),
            List.of(new Color(0x0B4F79), new Color(0xD55E00), new Color(0x009E73), new Color(0x7A4B8C)),
            List.of(new Color(0xF1F6FA), new Color(0xCBDDEA), new Color(0x8DB3D0), new Color(0x54748D)));

    /** For dark screens. */
    public static final ChartStyle DARK = new ChartStyle(
            new Palette(
                    true,
                    Palette.DARK.canvas(),
                    Palette.DARK.grid(),
                    Palette.DARK.gridMajor(),
                    Palette.DARK.text(),
                    Palette.DARK.muted(),
                    Palette.DARK.accent(),
                    new Color(0x5B6472),
                    new Color(0xA9B4C2),
                    Palette.DARK.moving(),
                    Palette.DARK.movingOutline(),
                    new Color(0x3FA7D6),
                    new Color(0xCDEBFA),
                    new Color(0x2BC48A),
                    new Color(0xFF6B5E),
                    Palette.DARK.collision(),
                    Palette.DARK.reference(),
                    Palette.DARK.sensors()),
            new Color(0x2C323A),
            List.of(new Color(0x7FC8F2), new Color(0xFF9A52), new Color(0x2BC48A), new Color(0xD9A6E8)),
            List.of(new Color(0x1F2F3C), new Color(0x35566E), new Color(0x5C8FB5), new Color(0xB7DDF5)));

    /** Copies the lists. */
    public ChartStyle {
        series = List.copyOf(series);
        classes = List.copyOf(classes);
    }

    public Color series(int index) {
        return series.get(index % series.size());
    }

    /** Returns the style of the line of a series; the first 16 differ in colour or dash pattern. */
    public LineStyle lineStyle(int index) {
        DashPattern[] patterns = DashPattern.values();
        return new LineStyle(series(index), 1.8, patterns[(index + index / series.size()) % patterns.length]);
    }

    /** Returns the colour of the area of a series. */
    public Color band(int index) {
        return withOpacity(series(index), BAND_OPACITY);
    }

    /** Returns a translucent colour; opacity in [0, 1]. */
    public static Color withOpacity(Color colour, double opacity) {
        return Palette.withAlpha(colour, (int) Math.round(255 * opacity));
    }
}
