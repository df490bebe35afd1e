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
        // Zero is always shown, so that the chart's heights are honest.
        DoubleStream shown = DoubleStream.concat(DoubleStream.of(0), signal.curves().stream().flatMapToDouble(data::values));
        return new StripScale(signal, span, plot, data, Axis.covering(signal.unit(), shown));
    }

    double x(double time) {
        return plot.getX() + span.share(time) * plot.getWidth();
    }

    double y(double value) {
        return plot.getMaxY() - values.share(value) * plot.getHeight();
    }
}
