package faultline.gui.instrument;

import faultline.engine.Frame;
import faultline.paint.plot.Axis;
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
record StripScale(Signal signal, TimeSpan span, Rectangle2D plot, StripData data, Axis values) {

    static final int LEFT = 46;
    static final int RIGHT = 14;
    private static final int TOP = 28;
    private static final int BOTTOM = 22;

    /** A chart of a width and height in pixels. */
    static StripScale of(Frame frame, Signal signal, TimeSpan span, int width, int height) {
        Rectangle2D plot = new Rectangle2D.Double(LEFT, TOP, Math.max(1, width - LEFT - RIGHT), Math.max(1, height - TOP - BOTTOM));
        StripData data = StripData.of(frame, span, (int) plot.getWidth());
        return new StripScale(signal, span, plot, data, axis(signal, data));
    }

    /** Zero is always shown, so that the chart's heights are honest. */
    private static Axis axis(Signal signal, StripData data) {
        double[] values = values(signal, data).toArray();
        boolean flat = DoubleStream.of(values).allMatch(value -> value == 0);
        return flat ? Axis.linear(signal.unit(), 0, 1) : Axis.covering(signal.unit(),
                DoubleStream.concat(DoubleStream.of(0), DoubleStream.of(values)));
    }

    private static DoubleStream values(Signal signal, StripData data) {
        return signal.curves().stream().flatMapToDouble(data::values);
    }

    /** Whether there is nothing to draw. */
    boolean isEmpty() {
        return values(signal, data).findAny().isEmpty();
    }

    double x(double time) {
        return plot.getX() + span.share(time) * plot.getWidth();
    }

    double y(double value) {
        return plot.getMaxY() - values.share(value) * plot.getHeight();
    }
}
