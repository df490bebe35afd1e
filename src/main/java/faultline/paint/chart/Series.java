package faultline.paint.chart;

import faultline.geometry.Vector2;
import java.util.List;

/**
 * What a chart shows, in its own values. A name that is not empty stands in the legend; the style picks colour, dash
 * and marker.
 */
public sealed interface Series {

    /**
     * What the legend calls it.
     *
     * @return empty for what is not in the legend
     */
    String name();

    /**
     * A line.
     *
     * @param name in the legend
     * @param points in order; one that is not finite breaks the line
     * @param styleIndex from 0
     */
    record Line(String name, List<Vector2> points, int styleIndex) implements Series {
        public Line {
            points = List.copyOf(points);
        }
    }

    /**
     * Single points.
     *
     * @param name in the legend
     * @param points in any order
     * @param styleIndex from 0
     */
    record Points(String name, List<Vector2> points, int styleIndex) implements Series {
        public Points {
            points = List.copyOf(points);
        }
    }

    /**
     * What lies between two lines.
     *
     * @param name in the legend
     * @param upper in the order of x
     * @param lower in the order of x
     * @param styleIndex from 0
     */
    record Band(String name, List<Vector2> upper, List<Vector2> lower, int styleIndex) implements Series {
        public Band {
            upper = List.copyOf(upper);
            lower = List.copyOf(lower);
        }
    }

    /**
     * A map of classes over the whole chart: rows from the lower edge up, each from left to right, in equal steps along
     * the axes.
     *
     * @param names of the classes in the legend
     * @param rows of cells, each the place of its class in {@code names}
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
     * A few words at a place.
     *
     * @param name what stands there
     * @param position the text's beginning
     */
    record Note(String name, Vector2 position) implements Series {}
}
