package faultline.gui.instrument;

import faultline.gui.theme.Theme;
import faultline.paint.plot.Dash;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Stroke;
import java.util.List;
import java.util.function.Function;

/**
 * One line of a strip chart.
 *
 * @param name for the legend
 * @param channel of {@link faultline.engine.record.Channels}
 * @param colour by theme
 * @param dash so that lines are told apart without colours
 */
record Curve(String name, int channel, Function<Theme, Color> colour, Dash dash) {

    private static final float WIDTH = 1.6f;

    /** A line in one of the colours of charts, counted from 0. */
    static Curve of(String name, int channel, int series, Dash dash) {
        return new Curve(name, channel, theme -> series(theme).get(series), dash);
    }

    private static List<Color> series(Theme theme) {
        return (theme == Theme.DARK ? faultline.paint.plot.Theme.DARK : faultline.paint.plot.Theme.LIGHT).series();
    }

    Stroke stroke() {
        if (dash == Dash.SOLID) {
            return new BasicStroke(WIDTH, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        }
        float[] lengths = new float[dash.lengths().size()];
        for (int i = 0; i < lengths.length; i++) {
            lengths[i] = dash.lengths().get(i).floatValue();
        }
        return new BasicStroke(WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, lengths, 0);
    }
}
