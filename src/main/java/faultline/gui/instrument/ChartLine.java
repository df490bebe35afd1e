package faultline.gui.instrument;

import faultline.gui.theme.Theme;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import java.awt.Color;
import java.util.function.Function;

/**
 * A line of a strip chart: a channel of {@link faultline.engine.recording.TraceChannels}, with a colour by theme and a
 * dash pattern that distinguishes it without colour.
 */
record ChartLine(String name, int channel, Function<Theme, Color> colour, DashPattern dash) {

    private static final double LINE_WIDTH = 1.6;

    /** Returns this line with another name. */
    ChartLine withName(String newName) {
        return new ChartLine(newName, channel, colour, dash);
    }

    /** Returns the style of this line in the colours of a theme. */
    LineStyle style(Theme theme) {
        return new LineStyle(colour.apply(theme), LINE_WIDTH, dash);
    }
}
