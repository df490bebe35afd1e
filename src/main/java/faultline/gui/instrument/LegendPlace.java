package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.paint.chart.LegendRows;
import java.util.List;

/**
 * A legend in the picture of a strip chart: its upper left corner, the height that it takes above the plot, and the
 * width beside it, pixels.
 */
record LegendPlace(LegendRows<LegendEntry> rows, Vector2 corner, int above, int beside) {

    static final int ROW_HEIGHT = 15;
    static final int GAP = 3;

    /** No legend. */
    static final LegendPlace NONE = new LegendPlace(LegendEntry.rows(List.of(), name -> 0, 0), Vector2.ZERO, 0, 0);

    /** Returns a legend above the ribbon over a plot that begins at an x coordinate, pixels. */
    static LegendPlace above(LegendRows<LegendEntry> rows, int left) {
        return new LegendPlace(rows, new Vector2(left, 0), rows.rows().size() * ROW_HEIGHT, 0);
    }

    /** Returns a legend to the right of a plot, at an x coordinate and of a width in pixels. */
    static LegendPlace beside(LegendRows<LegendEntry> rows, int left, int width) {
        return new LegendPlace(rows, new Vector2(left, 0), 0, width);
    }
}
