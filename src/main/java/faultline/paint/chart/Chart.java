package faultline.paint.chart;

import java.util.List;

/**
 * A chart: what it shows against which axes.
 *
 * @param title above it
 * @param x the axis to the right
 * @param y the axis up
 * @param series from the lowest to the topmost
 */
public record Chart(String title, Axis x, Axis y, List<Series> series) {
    /** Copies the list. */
    public Chart {
        series = List.copyOf(series);
    }
}
