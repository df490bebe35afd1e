package faultline.paint.chart;

import faultline.geometry.Vector2;
import java.util.List;
import java.util.function.Consumer;

/**
 * A series of a chart, in the values of its axes. A name that is not empty appears in the legend; the style index
 * selects colour, dash pattern and marker.
 */
public sealed interface Series {

    /** Returns the name in the legend; empty for a series without an entry. */
    String name();

    /** Calls the function for this kind of series. */
    void match(SeriesCases cases);

    /** A function for each kind of series. */
    record SeriesCases(
            Consumer<Line> line,
            Consumer<Points> points,
            Consumer<Band> band,
            Consumer<Cells> cells,
            Consumer<Note> note) {}

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

        @Override
        public void match(SeriesCases cases) {
            cases.line.accept(this);
        }
    }

    /** Single points in any order, with the name in the legend and the style index, from 0. */
    record Points(String name, List<Vector2> points, int styleIndex) implements Series {
        public Points {
            points = List.copyOf(points);
        }

        @Override
        public void match(SeriesCases cases) {
            cases.points.accept(this);
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

        @Override
        public void match(SeriesCases cases) {
            cases.band.accept(this);
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

        @Override
        public void match(SeriesCases cases) {
            cases.cells.accept(this);
        }
    }

    /** A text that begins at a point. */
    record Note(String name, Vector2 position) implements Series {
        @Override
        public void match(SeriesCases cases) {
            cases.note.accept(this);
        }
    }
}
