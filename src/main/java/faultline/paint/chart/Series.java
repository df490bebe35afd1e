package faultline.paint.chart;

import faultline.geometry.Vector2;
import java.util.List;

/**
 * A series of a chart, in the values of its axes. A name that is not empty appears in the legend; the style index
 * selects colour, dash pattern and marker.
 */
public sealed interface Series {

    /** Returns the name in the legend; empty for a series without an entry. */
    String name();

    /**
     * A line.
     *
     * @param name the name in the legend
     * @param points in order; one that is not finite is a gap
     * @param styleIndex the style index, from 0
     */
    record Line(String name, List<Vector2> points, int styleIndex) implements Series {
        public Line {
            points = List.copyOf(points);
        }
    }

    /**
     * Single points.
     *
     * @param name the name in the legend
     * @param points the points, in any order
     * @param styleIndex the style index, from 0
     */
    record Points(String name, List<Vector2> points, int styleIndex) implements Series {
        public Points {
            points = List.copyOf(points);
        }
    }

    /**
     * The band between two lines.
     *
     * @param name the name in the legend
     * @param upper the points of the upper border, in the order of x
     * @param lower the points of the lower border, in the order of x
     * @param styleIndex the style index, from 0
     */
    record Band(String name, List<Vector2> upper, List<Vector2> lower, int styleIndex) implements Series {
        public Band {
            upper = List.copyOf(upper);
            lower = List.copyOf(lower);
        }
    }

    /**
     * A map of classes that fills the chart: rows from the lower edge up, each from left to right, in equal steps along
     * the axes.
     *
     * @param names the names of the classes in the legend
     * @param rows the rows of cells, each the index of its class in {@code names}
     */
    record Cells(List<String> names, List<List<Integer>> rows) implements Series {
        public Cells {
            names = List.copyOf(names);
            rows = List.copyOf(rows);
        }

        @Override
        public String name() {
            return "";
        }
    }

    /**
     * A text at a point.
     *
     * @param name the text
     * @param position the position of its start
     */
    record Note(String name, Vector2 position) implements Series {}
}
