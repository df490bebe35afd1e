package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineItem;
import faultline.paint.chart.PlotPainter;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Palette;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

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

    /** Paints what is between the lines and the shades; before all lines, because it would cover their crossings. */
    void paintHalos() {
        if (!shades.isEmpty()) {
            referenceData().ifPresent(data -> paintHalos(data, line -> LegendEntry.referenceStyle(theme)));
            paintHalos(scale.data(), line -> line.style(theme));
        }
    }

    private void paintHalos(StripData data, Function<ChartLine, LineStyle> styleOf) {
        boolean[] shaded = shadedBuckets(data);
        for (ChartLine line : scale.signal().lines()) {
            LineStyle halo = LineStyle.solid(
                    theme.palette().canvas(), styleOf.apply(line).width() + HALO_WIDTH);
            data.valuesOf(line).ifPresent(values -> painter.paintLine(shadedPart(data, values, shaded), halo));
        }
    }

    /** Returns which buckets have a shade, or one beside them. */
    private boolean[] shadedBuckets(StripData data) {
        int count = (int) Math.max(0, data.to() - data.from());
        // How many shades begin in each bucket, less those that have ended in the one before.
        int[] changes = new int[count + 1];
        for (TimelineItem shade : shades) {
            int first = (int) clamp(data.bucketOf(shade.start()) - 1 - data.from(), count);
            int end = (int)
                    clamp(data.bucketOf(Math.min(shade.end(), content.span().end())) + 2 - data.from(), count);
            changes[first]++;
            changes[end]--;
        }
        boolean[] shaded = new boolean[count];
        int active = 0;
        for (int i = 0; i < count; i++) {
            active += changes[i];
            shaded[i] = active > 0;
        }
        return shaded;
    }

    private static long clamp(long bucket, int count) {
        return Math.max(0, Math.min(count, bucket));
    }

    private static List<Vector2> shadedPart(StripData data, StripData.LineValues values, boolean[] shaded) {
        List<Vector2> part = new ArrayList<>();
        for (long bucket = data.from(); bucket < data.to(); bucket++) {
            part.add(
                    shaded[(int) (bucket - data.from())]
                            ? new Vector2(data.timeOf(bucket), values.middle(bucket))
                            : GAP);
        }
        return part;
    }

    void paint(ChartLine line) {
        paint(scale.data(), line, line.style(theme));
    }

    /** Paints the same lines of the reference run. */
    void paintReference() {
        referenceData()
                .ifPresent(data ->
                        scale.signal().lines().forEach(line -> paint(data, line, LegendEntry.referenceStyle(theme))));
    }

    private Optional<StripData> referenceData() {
        return content.referenceData((int) scale.plot().area().width());
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
            middle.add(new Vector2(time, values.middle(bucket)));
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
