package faultline.gui.instrument;

import faultline.paint.chart.Axis;
import faultline.paint.chart.Plot;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.TextStyle;
import java.awt.Color;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * The content of a strip chart and its plot.
 *
 * @param signal the lines
 * @param data their recorded values
 * @param plot the rectangle of the lines, with its axes of time and value
 * @param sensors the ids of the sensors in the robot's order
 * @param legend the names of the lines above the plot; no rows if they are named elsewhere
 */
record StripScale(SignalGroup signal, StripData data, Plot plot, List<String> sensors, LegendRows legend) {

    static final int LEFT_MARGIN = 46;
    static final int RIGHT_MARGIN = 20;
    /** The height of the ribbon above the plot with the gaps around it, pixels. */
    static final int TOP_MARGIN = 24;

    static final int LEGEND_ROW_HEIGHT = 15;
    static final int FONT_SIZE = 11;
    private static final int BOTTOM_MARGIN = 20;
    /** The least height of a plot below several rows of a legend, pixels. */
    private static final int MIN_PLOT_HEIGHT = 45;

    /** Returns the scale of a chart, with a legend above the plot or without; width and height in pixels. */
    static StripScale of(StripContent content, boolean legend, int width, int height) {
        SignalGroup signal = content.signal();
        int plotWidth = Math.max(1, width - LEFT_MARGIN - RIGHT_MARGIN);
        LegendRows names = legend
                ? legend(content, plotWidth, height - TOP_MARGIN - BOTTOM_MARGIN - MIN_PLOT_HEIGHT)
                : LegendRows.NONE;
        int top = TOP_MARGIN + names.rows().size() * LEGEND_ROW_HEIGHT;
        PixelRectangle area =
                new PixelRectangle(LEFT_MARGIN, top, plotWidth, Math.max(1, height - top - BOTTOM_MARGIN));
        StripData data = StripData.of(content.frame(), content.span(), plotWidth);
        Axis time = Axis.linear("s", content.span().start(), content.span().end());
        List<String> ids = content.frame().snapshot().sensors().stream()
                .map(sensor -> sensor.spec().id())
                .toList();
        double[] all = Stream.concat(Stream.of(data), content.referenceData(plotWidth).stream())
                .flatMapToDouble(run -> values(signal, run))
                .toArray();
        Axis values = content.range().axis(signal.unit(), all);
        return new StripScale(signal, data, new Plot(area, time, values), ids, names);
    }

    /** Returns as many rows of the legend as have room in a height, at least one. */
    private static LegendRows legend(StripContent content, int width, int height) {
        TextStyle style = TextStyle.plain(FONT_SIZE, Color.BLACK);
        return LegendRows.of(LegendEntry.of(content.signal(), content.reference() != null), style::estimateWidth, width)
                .first(Math.max(1, height / LEGEND_ROW_HEIGHT));
    }

    /** Returns the index of a sensor in the robot's order, 0 if there is none. */
    int sensorIndex(String id) {
        return Math.max(0, sensors.indexOf(id));
    }

    private static DoubleStream values(SignalGroup signal, StripData data) {
        return signal.lines().stream().flatMapToDouble(data::values);
    }

    /** Returns whether there is no data. */
    boolean isEmpty() {
        return values(signal, data).findAny().isEmpty();
    }
}
