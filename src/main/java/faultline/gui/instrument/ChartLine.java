package faultline.gui.instrument;

import faultline.gui.theme.Theme;
import faultline.paint.surface.DashPattern;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Stroke;
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

    private static final float LINE_WIDTH = 1.6f;

    /** A line in one of the colours of charts, counted from 0. */
    static ChartLine seriesLine(String name, int channel, int series, DashPattern dash) {
        return new ChartLine(name, channel, theme -> series(theme).get(series), dash);
    }

    private static List<Color> series(Theme theme) {
        return (theme == Theme.DARK
                        ? faultline.paint.surface.ChartStyle.DARK
                        : faultline.paint.surface.ChartStyle.LIGHT)
                .series();
    }

    Stroke stroke() {
        if (dash == DashPattern.SOLID) {
            return new BasicStroke(LINE_WIDTH, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        }
        float[] lengths = new float[dash.lengths().size()];
        for (int i = 0; i < lengths.length; i++) {
            lengths[i] = dash.lengths().get(i).floatValue();
        }
        return new BasicStroke(LINE_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, lengths, 0);
    }
}
