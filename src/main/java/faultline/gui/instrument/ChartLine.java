package faultline.gui.instrument;

import faultline.engine.recording.TraceChannels;
import faultline.gui.theme.Theme;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import java.awt.Color;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * A line of a strip chart, with a colour by theme and a dash pattern that distinguishes it without colour.
 *
 * @param name its name
 * @param sensor the id of the sensor whose reading it shows; empty for a value of the controller
 * @param channel its channel of {@link TraceChannels}; for a sensor, that of the first one in the robot's list
 * @param factor what the values of the channel are multiplied by to have the unit in which they are shown
 */
record ChartLine(
        String name, String sensor, int channel, double factor, Function<Theme, Color> colour, DashPattern dash) {

    private static final double LINE_WIDTH = 1.6;

    /** Creates a line whose values are shown in the unit of its channel. */
    ChartLine(String name, String sensor, int channel, Function<Theme, Color> colour, DashPattern dash) {
        this(name, sensor, channel, 1, colour, dash);
    }

    /** Returns this line with another name. */
    ChartLine withName(String newName) {
        return new ChartLine(newName, sensor, channel, factor, colour, dash);
    }

    /** Returns this line for a sensor that is called otherwise, given what returns its id for the one before. */
    ChartLine withSensor(UnaryOperator<String> presentId) {
        return sensor.isEmpty() ? this : new ChartLine(name, presentId.apply(sensor), channel, factor, colour, dash);
    }

    /** Returns whether another line shows the same values. */
    boolean showsSameAs(ChartLine other) {
        return sensor.equals(other.sensor) && channel == other.channel;
    }

    /** Returns the channel of this line for a robot with the given sensors; empty if it lacks the sensor. */
    OptionalInt channelIn(List<String> sensors) {
        if (sensor.isEmpty()) {
            return OptionalInt.of(channel);
        }
        int index = sensors.indexOf(sensor);
        int offset = TraceChannels.trueReading(index) - TraceChannels.trueReading(0);
        return index < 0 ? OptionalInt.empty() : OptionalInt.of(channel + offset);
    }

    /** Returns the style of this line in the colours of a theme. */
    LineStyle style(Theme theme) {
        return new LineStyle(colour.apply(theme), LINE_WIDTH, dash);
    }
}
