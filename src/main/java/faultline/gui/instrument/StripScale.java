package faultline.gui.instrument;

import faultline.paint.chart.Axis;
import faultline.paint.chart.LegendRows;
import faultline.paint.chart.Plot;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.TextStyle;
import java.awt.Color;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * The content of a strip chart and its plot, with axes of time and value. The legend has no rows if the lines are named
 * elsewhere.
 */
record StripScale(SignalGroup signal, StripData data, Plot plot, LegendPlace legend) {

    static final int LEFT_MARGIN = 46;
    static final int RIGHT_MARGIN = 20;
    /** The height of the ribbon above the plot with the gaps around it, pixels. */
    static final int TOP_MARGIN = 24;

    static final int FONT_SIZE = 11;
    private static final int BOTTOM_MARGIN = 20;
    /** The space beside the labels of the vertical axis, pixels. */
    private static final int LABEL_GAP = 12;
    /** The minimum height of a plot below several rows of a legend, pixels. */
    private static final int MIN_PLOT_HEIGHT = 45;
    /** The minimum height of a plot below a row of a legend, pixels. */
    private static final int LOW_PLOT_HEIGHT = 30;
    /** The minimum width of a plot beside a legend, pixels. */
    private static final int MIN_PLOT_WIDTH = 100;

    /** Returns the scale of a chart, with a legend beside the data or without; width and height in pixels. */
    static StripScale of(StripContent content, boolean legend, int width, int height) {
        LegendPlace names = legend ? legend(content, width, height) : LegendPlace.NONE;
        int room = Math.max(1, width - LEFT_MARGIN - RIGHT_MARGIN - names.beside());
        SignalGroup signal = content.signal();
        StripData data = StripData.of(content.frame(), content.span(), room);
        Axis time = Axis.linear("s", content.span().start(), content.span().end());
        double[] all = Stream.concat(Stream.of(data), content.referenceData(room).stream())
                .flatMapToDouble(run -> values(signal, run))
                .toArray();
        Axis values = content.range().axis(signal.unit(), all);
        int left = leftMargin(values);
        PixelRectangle area = new PixelRectangle(
                left,
                TOP_MARGIN + names.above(),
                Math.max(1, room + LEFT_MARGIN - left),
                Math.max(1, height - TOP_MARGIN - names.above() - BOTTOM_MARGIN));
        return new StripScale(signal, data, new Plot(area, time, values), names);
    }

    /** Returns the margin in which the labels of an axis fit, pixels. */
    private static int leftMargin(Axis values) {
        TextStyle style = TextStyle.plain(FONT_SIZE, Color.BLACK);
        double widest = values.ticks().stream()
                .map(Axis::formatTick)
                .mapToDouble(style::estimateWidth)
                .max()
                .orElse(0);
        return Math.max(LEFT_MARGIN, (int) Math.ceil(widest) + LABEL_GAP);
    }

    /**
     * Returns the legend above the plot, or above the labels of its axis, too, or to the right of the plot if it is too
     * high. Rows for which there is no room are omitted, and all if one name is wider than the picture.
     */
    private static LegendPlace legend(StripContent content, int width, int height) {
        TextStyle style = TextStyle.plain(FONT_SIZE, Color.BLACK);
        List<LegendEntry> entries = LegendEntry.of(content.signal(), content.reference());
        int plotWidth = width - LEFT_MARGIN - RIGHT_MARGIN;
        LegendRows<LegendEntry> above = LegendEntry.rows(entries, style::estimateWidth, plotWidth);
        int plotHeight = height - TOP_MARGIN - BOTTOM_MARGIN;
        int fewest = plotHeight - LegendPlace.ROW_HEIGHT >= LOW_PLOT_HEIGHT ? 1 : 0;
        int room = Math.max(fewest, (plotHeight - MIN_PLOT_HEIGHT) / LegendPlace.ROW_HEIGHT);
        LegendRows<LegendEntry> wide = LegendEntry.rows(entries, style::estimateWidth, width - 2 * LegendPlace.GAP);
        if (above.rows().size() > room && wide.rows().size() <= room && wide.width() <= width - 2 * LegendPlace.GAP) {
            return LegendPlace.above(wide, LegendPlace.GAP);
        }
        LegendRows<LegendEntry> column = LegendEntry.rows(entries, style::estimateWidth, 0);
        int beside = (int) Math.ceil(column.width());
        if (above.rows().size() > room && plotWidth - beside >= MIN_PLOT_WIDTH) {
            return LegendPlace.beside(
                    column.first(height / LegendPlace.ROW_HEIGHT), width - beside - LegendPlace.GAP, beside);
        }
        LegendRows<LegendEntry> shown = above.first(room);
        return shown.width() > width - LEFT_MARGIN ? LegendPlace.NONE : LegendPlace.above(shown, LEFT_MARGIN);
    }

    private static DoubleStream values(SignalGroup signal, StripData data) {
        return signal.lines().stream().flatMapToDouble(data::values);
    }

    /** Returns whether there is no data. */
    boolean isEmpty() {
        return values(signal, data).findAny().isEmpty();
    }
}
