package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineItem;
import faultline.paint.chart.PlotPainter;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Palette;
import java.util.ArrayList;
import java.util.List;

/**
 * Paints the lines of a strip chart. If a bucket has several ticks, a band shows its least and greatest values and the
 * line is in the middle; a bucket without any is a gap. On the shades of faults, a halo separates lines from them,
 * because the colours of many sensors differ enough from the canvas only.
 */
final class StripLines {

    private static final int BAND_ALPHA = 80;
    /** The width of a halo in addition to that of its line, pixels. */
    private static final double HALO_WIDTH = 3;

    private static final Vector2 GAP = new Vector2(Double.NaN, Double.NaN);

    private final PlotPainter painter;
    private final Theme theme;
    private final StripScale scale;
    private final StripContent content;
    private final List<TimelineItem> shades;

    StripLines(PlotPainter painter, Theme theme, StripScale scale, StripContent content) {
        this.painter = painter;
        this.theme = theme;
        this.scale = scale;
        this.content = content;
        shades = content.items().stream().filter(TimelineItem::isInterval).toList();
    }

    void paint(ChartLine line) {
        paint(scale.data(), line, line.style(theme));
    }

    /** Paints the same lines of the reference run. */
    void paintReference() {
        int width = (int) scale.plot().area().width();
        content.referenceData(width)
                .ifPresent(data ->
                        scale.signal().lines().forEach(line -> paint(data, line, LegendEntry.referenceStyle(theme))));
    }

    private void paint(StripData data, ChartLine line, LineStyle style) {
        data.valuesOf(line).ifPresent(values -> paint(data, values, style));
    }

    private void paint(StripData data, StripData.LineValues values, LineStyle style) {
        List<Vector2> middle = new ArrayList<>();
        List<Vector2> lower = new ArrayList<>();
        List<Vector2> upper = new ArrayList<>();
        for (long bucket = data.from(); bucket < data.to(); bucket++) {
            double time = data.timeOf(bucket);
            float low = values.min(bucket);
            float high = values.max(bucket);
            middle.add(new Vector2(time, (low + high) / 2));
            if (Float.isFinite(low)) {
                lower.add(new Vector2(time, low));
                upper.add(new Vector2(time, high));
            } else {
                paintBand(upper, lower, style);
            }
        }
        paintBand(upper, lower, style);
        paintHalo(middle, style.width() + HALO_WIDTH, data.timeOf(1) - data.timeOf(0));
        painter.paintLine(middle, style);
    }

    /** Paints what is behind a line on shades, to the nearest of its points, which are some seconds apart. */
    private void paintHalo(List<Vector2> line, double width, double step) {
        List<Vector2> shaded = line.stream()
                .map(at -> shades.stream().anyMatch(shade -> isNear(shade, at.x(), step)) ? at : GAP)
                .toList();
        painter.paintLine(shaded, LineStyle.solid(theme.palette().canvas(), width));
    }

    private static boolean isNear(TimelineItem shade, double time, double step) {
        return shade.start() <= time + step && shade.end() >= time - step;
    }

    /** Paints a band without gaps, and empties its lists for the next one. */
    private void paintBand(List<Vector2> upper, List<Vector2> lower, LineStyle style) {
        if (upper.size() > 1 && !upper.equals(lower)) {
            painter.paintBand(upper, lower, Palette.withAlpha(style.colour(), BAND_ALPHA));
        }
        upper.clear();
        lower.clear();
    }
}
