package faultline.paint.chart;

import java.util.List;

/** A chart: an optional title, the axes, and the series from the lowest to the topmost. */
public record Chart(String title, Axis x, Axis y, List<Series> series) {
    /** Copies the list. */
    public Chart {
        series = List.copyOf(series);
    }
}
