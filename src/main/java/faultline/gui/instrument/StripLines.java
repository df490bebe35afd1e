package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.paint.chart.PlotPainter;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Palette;
import java.util.ArrayList;
import java.util.List;

/**
 * Paints the lines of a strip chart. If a bucket has several ticks, a band shows its least and greatest values and the
 * line is in the middle; a bucket without any is a gap.
 */
final class StripLines {

    private static final int BAND_ALPHA = 80;

    private final PlotPainter painter;
    private final Theme theme;
    private final StripScale scale;

    StripLines(PlotPainter painter, Theme theme, StripScale scale) {
        this.painter = painter;
        this.theme = theme;
        this.scale = scale;
    }

    void paint(ChartLine line) {
        paint(scale.data(), line, line.style(theme));
    }

    /** Paints the same lines of the reference run. */
    void paintReference(StripContent content) {
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
        painter.paintLine(middle, style);
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
