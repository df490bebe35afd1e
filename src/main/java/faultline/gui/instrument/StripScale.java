package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.paint.chart.Axis;
import java.awt.geom.Rectangle2D;
import java.util.stream.DoubleStream;

/**
 * What a strip chart of a certain size shows, and where on it times and values are.
 *
 * @param signal what is shown
 * @param span when
 * @param plot the rectangle of the lines, pixels
 * @param data what is recorded of it
 * @param values the axis upwards
 */
record StripScale(SignalGroup signal, TimeSpan span, Rectangle2D plot, StripData data, Axis values) {

    static final int LEFT_MARGIN = 46;
    static final int RIGHT_MARGIN = 14;
    private static final int TOP_MARGIN = 28;
    private static final int BOTTOM_MARGIN = 22;

    /** A chart of a width and height in pixels. */
    static StripScale of(SessionFrame frame, SignalGroup signal, TimeSpan span, int width, int height) {
        Rectangle2D plot = new Rectangle2D.Double(
                LEFT_MARGIN,
                TOP_MARGIN,
                Math.max(1, width - LEFT_MARGIN - RIGHT_MARGIN),
                Math.max(1, height - TOP_MARGIN - BOTTOM_MARGIN));
        StripData data = StripData.of(frame, span, (int) plot.getWidth());
        return new StripScale(signal, span, plot, data, createAxis(signal, data));
    }

    /** Zero is always shown, so that the chart's heights are honest. */
    private static Axis createAxis(SignalGroup signal, StripData data) {
        double[] values = values(signal, data).toArray();
        boolean flat = DoubleStream.of(values).allMatch(value -> value == 0);
        return flat
                ? Axis.linear(signal.unit(), 0, 1)
                : Axis.covering(signal.unit(), DoubleStream.concat(DoubleStream.of(0), DoubleStream.of(values)));
    }

    private static DoubleStream values(SignalGroup signal, StripData data) {
        return signal.lines().stream().flatMapToDouble(data::values);
    }

    /** Whether there is nothing to draw. */
    boolean isEmpty() {
        return values(signal, data).findAny().isEmpty();
    }

    double x(double time) {
        return plot.getX() + span.shareOf(time) * plot.getWidth();
    }

    double y(double value) {
        return plot.getMaxY() - values.fractionOf(value) * plot.getHeight();
    }
}
