package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The names of a strip chart's lines with a sample of each, in rows of a limited width.
 *
 * @param rows the entries, from the top
 */
record LegendRows(List<List<LegendEntry>> rows) {

    /** No names. */
    static final LegendRows NONE = new LegendRows(List.of());

    private static final double SAMPLE_WIDTH = 26;
    private static final double GAP = 6;
    private static final double ENTRY_GAP = 16;
    /** From the middle of a line of text down to its baseline, as a share of its size. */
    private static final double BASELINE = 0.36;

    /** Breaks entries into rows; {@code textWidth} measures names, and the width is in pixels. */
    static LegendRows of(List<LegendEntry> entries, ToDoubleFunction<String> textWidth, double width) {
        List<List<LegendEntry>> rows = new ArrayList<>();
        double end = 0;
        for (LegendEntry entry : entries) {
            double needed = width(entry, textWidth);
            if (rows.isEmpty() || end + ENTRY_GAP + needed > width) {
                rows.add(new ArrayList<>());
                end = needed;
            } else {
                end += ENTRY_GAP + needed;
            }
            rows.get(rows.size() - 1).add(entry);
        }
        return new LegendRows(rows);
    }

    private static double width(LegendEntry entry, ToDoubleFunction<String> textWidth) {
        return SAMPLE_WIDTH + GAP + textWidth.applyAsDouble(entry.name());
    }

    /** Returns the width of the widest row, pixels. */
    double width(ToDoubleFunction<String> textWidth) {
        return rows.stream()
                .mapToDouble(row -> row.stream()
                                .mapToDouble(entry -> ENTRY_GAP + width(entry, textWidth))
                                .sum()
                        - ENTRY_GAP)
                .max()
                .orElse(0);
    }

    /** Returns the first rows; what follows them is left out. */
    LegendRows first(int count) {
        return new LegendRows(rows.subList(0, Math.min(count, rows.size())));
    }

    /** Paints the rows from a point on their left upper corner; all lengths are in pixels. */
    void paint(
            Surface surface,
            Theme theme,
            TextStyle style,
            ToDoubleFunction<String> textWidth,
            Vector2 corner,
            double rowHeight) {
        double middle = corner.y() + rowHeight / 2;
        for (List<LegendEntry> row : rows) {
            double x = corner.x();
            for (LegendEntry entry : row) {
                Vector2 left = new Vector2(x, middle);
                surface.draw(
                        Shapes.polyline(List.of(left, left.plus(new Vector2(SAMPLE_WIDTH, 0)))),
                        entry.style().apply(theme));
                surface.drawText(
                        entry.name(), left.plus(new Vector2(SAMPLE_WIDTH + GAP, BASELINE * style.size())), style);
                x += width(entry, textWidth) + ENTRY_GAP;
            }
            middle += rowHeight;
        }
    }
}
