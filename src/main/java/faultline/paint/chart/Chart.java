package faultline.paint.chart;

import java.util.List;

/**
 * A chart: series and their axes.
 *
 * @param title the title above the chart; may be empty
 * @param x the horizontal axis
 * @param y the vertical axis
 * @param series the series, from the lowest to the topmost
 */
public record Chart(String title, Axis x, Axis y, List<Series> series) {
    /** Copies the list. */
    public Chart {
        series = List.copyOf(series);
    }
}
