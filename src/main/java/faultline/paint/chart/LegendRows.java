package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/**
 * The entries of a legend, each a sample and a name, in rows of a limited width, from the top. All lengths are in
 * pixels.
 */
public record LegendRows<E>(List<List<E>> rows, Function<E, String> name, ToDoubleFunction<String> textWidth) {

    /** The width of a sample, pixels. */
    public static final double SAMPLE_WIDTH = 26;

    private static final double NAME_GAP = 5;
    private static final double ENTRY_GAP = 14;
    /** The distance from the middle of a line of text down to its baseline, as a share of its size. */
    private static final double BASELINE = 4.0 / 11;

    /** Paints the sample of an entry. */
    @FunctionalInterface
    public interface SamplePainter<E> {

        /** Paints a sample to the right of a point in the middle of its left edge. */
        void paint(E entry, Vector2 left);
    }

    public LegendRows {
        rows = rows.stream().map(List::copyOf).toList();
    }

    /** Breaks entries into rows of a width. */
    public static <E> LegendRows<E> of(
            List<E> entries, Function<E, String> name, ToDoubleFunction<String> textWidth, double width) {
        List<List<E>> rows = new ArrayList<>();
        double end = 0;
        for (E entry : entries) {
            double needed = entryWidth(textWidth.applyAsDouble(name.apply(entry)));
            if (rows.isEmpty() || end + ENTRY_GAP + needed > width) {
                rows.add(new ArrayList<>());
                end = needed;
            } else {
                end += ENTRY_GAP + needed;
            }
            rows.get(rows.size() - 1).add(entry);
        }
        return new LegendRows<>(rows, name, textWidth);
    }

    private static double entryWidth(double nameWidth) {
        return SAMPLE_WIDTH + NAME_GAP + nameWidth;
    }

    private double widthOf(E entry) {
        return entryWidth(textWidth.applyAsDouble(name.apply(entry)));
    }

    /** {@return the width of the widest row} */
    public double width() {
        return rows.stream()
                .mapToDouble(row -> row.stream()
                                .mapToDouble(entry -> ENTRY_GAP + widthOf(entry))
                                .sum()
                        - ENTRY_GAP)
                .max()
                .orElse(0);
    }

    /** Returns the first rows; what follows them is omitted. */
    public LegendRows<E> first(int count) {
        return new LegendRows<>(rows.subList(0, Math.min(count, rows.size())), name, textWidth);
    }

    /** Paints the rows from a point in their left upper corner. */
    public void paint(Surface surface, TextStyle style, Vector2 corner, double rowHeight, SamplePainter<E> samples) {
        double middle = corner.y() + rowHeight / 2;
        for (List<E> row : rows) {
            double x = corner.x();
            for (E entry : row) {
                Vector2 left = new Vector2(x, middle);
                samples.paint(entry, left);
                surface.drawText(
                        name.apply(entry),
                        left.plus(new Vector2(SAMPLE_WIDTH + NAME_GAP, BASELINE * style.size())),
                        style);
                x += widthOf(entry) + ENTRY_GAP;
            }
            middle += rowHeight;
        }
    }
}
