package faultline.gui.instrument;

import faultline.gui.theme.Theme;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import java.awt.Color;
import java.util.List;
import java.util.function.Function;

/**
 * One line of a strip chart.
 *
 * @param name for the legend
 * @param channel of {@link faultline.engine.recording.TraceChannels}
 * @param colour by theme
 * @param dash so that lines are told apart without colours
 */
record ChartLine(String name, int channel, Function<Theme, Color> colour, DashPattern dash) {

    private static final double LINE_WIDTH = 1.6;

    /** A line in one of the colours of charts, counted from 0. */
    static ChartLine seriesLine(String name, int channel, int series, DashPattern dash) {
        return new ChartLine(name, channel, theme -> series(theme).get(series), dash);
    }

    private static List<Color> series(Theme theme) {
        return (theme == Theme.DARK ? ChartStyle.DARK : ChartStyle.LIGHT).series();
    }

    /** Returns the style of this line in the colours of a theme. */
    LineStyle style(Theme theme) {
        return new LineStyle(colour.apply(theme), LINE_WIDTH, dash);
    }
}
