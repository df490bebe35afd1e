package faultline.paint.surface;

import java.awt.Color;
import java.util.List;

/**
 * The colours of a chart. Series differ in lightness, dash pattern and marker, not in hue alone.
 *
 * @param palette of scenes and of the chart's text and background
 * @param grid lines behind the data
 * @param series of lines and points, in order
 * @param classes of the cells of a map, from the best class to the worst
 */
public record ChartStyle(Palette palette, Color grid, List<Color> series, List<Color> classes) {

    /** For paper and light windows. */
    public static final ChartStyle LIGHT = new ChartStyle(
            Palette.LIGHT.forFigures(Color.WHITE, new Color(0x009E73), new Color(0xD55E00)),
            new Color(0xE3E7EC),
            List.of(new Color(0x0B4F79), new Color(0xD55E00), new Color(0x009E73), new Color(0x7A4B8C)),
            List.of(new Color(0xF1F6FA), new Color(0xCBDDEA), new Color(0x8DB3D0), new Color(0x54748D)));

    /** For dark windows. */
    public static final ChartStyle DARK = new ChartStyle(
            Palette.DARK.forFigures(Palette.DARK.canvas(), new Color(0x2BC48A), new Color(0xFF6B5E)),
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

    public LineStyle lineStyle(int index) {
        return new LineStyle(series(index), 1.8, DashPattern.values()[index % DashPattern.values().length]);
    }

    /** Returns a translucent colour; opacity in [0, 1]. */
    public static Color withOpacity(Color colour, double opacity) {
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), (int) Math.round(255 * opacity));
    }
}
