package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Plot;
import faultline.paint.surface.PixelRectangle;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * The content of a strip chart and its plot.
 *
 * @param signal the lines
 * @param data their recorded values
 * @param plot the rectangle of the lines, with its axes of time and value
 * @param sensors the ids of the sensors in the robot's order
 */
record StripScale(SignalGroup signal, StripData data, Plot plot, List<String> sensors) {

    static final int LEFT_MARGIN = 46;
    static final int RIGHT_MARGIN = 20;
    private static final int TOP_MARGIN = 24;
    private static final int BOTTOM_MARGIN = 20;

    /** Returns the scale of a chart; width and height in pixels. */
    static StripScale of(
            SessionFrame frame, SignalGroup signal, TimeSpan span, ValueRange range, int width, int height) {
        PixelRectangle area = new PixelRectangle(
                LEFT_MARGIN,
                TOP_MARGIN,
                Math.max(1, width - LEFT_MARGIN - RIGHT_MARGIN),
                Math.max(1, height - TOP_MARGIN - BOTTOM_MARGIN));
        StripData data = StripData.of(frame, span, (int) area.width());
        Axis time = Axis.linear("s", span.start(), span.end());
        List<String> ids = frame.snapshot().sensors().stream()
                .map(sensor -> sensor.spec().id())
                .toList();
        return new StripScale(
                signal,
                data,
                new Plot(
                        area,
                        time,
                        range.axis(signal.unit(), values(signal, data).toArray())),
                ids);
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
