package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Plot;
import faultline.paint.surface.PixelRectangle;
import java.util.stream.DoubleStream;

/**
 * The content of a strip chart and its plot.
 *
 * @param signal the lines
 * @param data their recorded values
 * @param plot the rectangle of the lines, with its axes of time and value
 */
record StripScale(SignalGroup signal, StripData data, Plot plot) {

    static final int LEFT_MARGIN = 46;
    static final int RIGHT_MARGIN = 14;
    private static final int TOP_MARGIN = 28;
    private static final int BOTTOM_MARGIN = 22;

    /** Returns the scale of a chart; width and height in pixels. */
    static StripScale of(
            SessionFrame frame, SignalGroup signal, TimeSpan span, boolean fromZero, int width, int height) {
        PixelRectangle area = new PixelRectangle(
                LEFT_MARGIN,
                TOP_MARGIN,
                Math.max(1, width - LEFT_MARGIN - RIGHT_MARGIN),
                Math.max(1, height - TOP_MARGIN - BOTTOM_MARGIN));
        StripData data = StripData.of(frame, span, (int) area.width());
        Axis time = Axis.linear("s", span.start(), span.end());
        return new StripScale(signal, data, new Plot(area, time, createAxis(signal, data, fromZero)));
    }

    /** Returns the vertical axis, which includes zero or only the values. */
    private static Axis createAxis(SignalGroup signal, StripData data, boolean fromZero) {
        double[] values = values(signal, data).toArray();
        boolean flat = DoubleStream.of(values).allMatch(value -> value == 0);
        return flat
                ? Axis.linear(signal.unit(), 0, 1)
                : Axis.covering(
                        signal.unit(),
                        DoubleStream.concat(
                                fromZero ? DoubleStream.of(0) : DoubleStream.empty(), DoubleStream.of(values)));
    }

    private static DoubleStream values(SignalGroup signal, StripData data) {
        return signal.lines().stream().flatMapToDouble(data::values);
    }

    /** Returns whether there is no data. */
    boolean isEmpty() {
        return values(signal, data).findAny().isEmpty();
    }
}
