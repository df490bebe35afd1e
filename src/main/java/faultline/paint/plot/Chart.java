package faultline.paint.plot;

import java.util.List;

/**
 * A chart: what it shows against which axes.
 *
 * @param title above it
 * @param x the axis to the right
 * @param y the axis up
 * @param marks from the lowest to the topmost
 */
public record Chart(String title, Axis x, Axis y, List<Mark> marks) {
    /** Copies the list. */
    public Chart {
        marks = List.copyOf(marks);
    }
}
