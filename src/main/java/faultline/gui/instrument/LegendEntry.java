package faultline.gui.instrument;

import faultline.engine.session.ReferenceRun;
import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.paint.chart.LegendRows;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/** A name in the legend of a strip chart, as a text of a {@link Surface}, and the style of its lines by theme. */
record LegendEntry(String name, Function<Theme, LineStyle> style) {

    private static final double REFERENCE_WIDTH = 1.4;

    /**
     * Returns the names of all lines from the front, and of a reference run, null for none, if its robot has one of the
     * lines.
     */
    static List<LegendEntry> of(SignalGroup signal, ReferenceRun reference) {
        List<LegendEntry> entries = new ArrayList<>();
        for (int i = signal.lines().size() - 1; i >= 0; i--) {
            ChartLine line = signal.lines().get(i);
            entries.add(new LegendEntry(TextStyle.literal(line.name()), line::style));
        }
        if (reference != null && signal.hasLineIn(reference.setup().robot().sensorIds())) {
            entries.add(new LegendEntry(Messages.get("signal.reference"), LegendEntry::referenceStyle));
        }
        return entries;
    }

    /** Breaks entries into rows of a width, pixels. */
    static LegendRows<LegendEntry> rows(List<LegendEntry> entries, ToDoubleFunction<String> textWidth, double width) {
        return LegendRows.of(entries, LegendEntry::name, textWidth, width);
    }

    /** Paints rows in a theme from a point in their left upper corner, pixels. */
    static void paint(
            LegendRows<LegendEntry> rows,
            Surface surface,
            Theme theme,
            TextStyle text,
            Vector2 corner,
            double rowHeight) {
        rows.paint(surface, text, corner, rowHeight, (entry, middle) -> {
            // In the middle of a row of pixels; between two rows a thin line would be pale.
            Vector2 left = new Vector2(middle.x(), Math.floor(middle.y()) + 0.5);
            Vector2 right = left.plus(new Vector2(LegendRows.SAMPLE_WIDTH, 0));
            surface.draw(Shapes.polyline(List.of(left, right)), entry.style().apply(theme));
        });
    }

    /** Returns the style of the lines of a reference run. */
    static LineStyle referenceStyle(Theme theme) {
        return new LineStyle(theme.palette().reference(), REFERENCE_WIDTH, DashPattern.DASHED);
    }
}
