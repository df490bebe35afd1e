package faultline.gui.instrument;

import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * A name in the legend of a strip chart.
 *
 * @param name the name
 * @param style the style of its lines by theme
 */
record LegendEntry(String name, Function<Theme, LineStyle> style) {

    private static final double REFERENCE_WIDTH = 1.4;

    /** Returns the names of all lines from the front, and of a reference run if there is one. */
    static List<LegendEntry> of(SignalGroup signal, boolean reference) {
        List<LegendEntry> entries = new ArrayList<>();
        for (int i = signal.lines().size() - 1; i >= 0; i--) {
            ChartLine line = signal.lines().get(i);
            entries.add(new LegendEntry(line.name(), line::style));
        }
        if (reference) {
            entries.add(new LegendEntry(Messages.get("signal.reference"), LegendEntry::referenceStyle));
        }
        return entries;
    }

    /** Returns the style of the lines of a reference run. */
    static LineStyle referenceStyle(Theme theme) {
        return new LineStyle(theme.palette().reference(), REFERENCE_WIDTH, DashPattern.DASHED);
    }
}
