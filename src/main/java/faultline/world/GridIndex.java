package faultline.world;

import faultline.geometry.Convex;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import java.util.Arrays;

/**
 * Keeps every figure in the square cells that it may touch, so that a look around costs the same in a room of forty walls as in one of
 * forty thousand. Finds all that {@link BruteForceIndex} finds within the distance.
 */
final class GridIndex implements FigureIndex {

    /** The side of a cell where the figures allow it, metres: about a third of what a robot looks round. */
    private static final double CELL = 0.4;

    /** The grid is made coarser until it has no more entries and cells than this for each figure. */
    private static final int MOST_PER_FIGURE = 16;
    private static final int MOST_BESIDES = 4096;

    private final Convex[] figures;
    private final int[] owners;
    private final double left;
    private final double bottom;
    private double cell;
    private int columns;
    private int rows;
    private int[] starts = new int[0];
    private int[] entries = new int[0];
    private final int[] lastSeen;
    private int look;

    /** A grid over all figures of a list, which may be cleared afterwards. */
    GridIndex(Candidates all) {
        int size = all.size();
        figures = new Convex[size];
        owners = new int[size];
        lastSeen = new int[size];
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            figures[i] = all.figure(i);
            owners[i] = all.owner(i);
            Vec centre = figures[i].centre();
            double reach = figures[i].reach();
            minX = Math.min(minX, centre.x() - reach);
            minY = Math.min(minY, centre.y() - reach);
            maxX = Math.max(maxX, centre.x() + reach);
            maxY = Math.max(maxY, centre.y() + reach);
        }
        left = minX;
        bottom = minY;
        build(maxX - minX, maxY - minY);
    }

    private void build(double width, double height) {
        long most = (long) MOST_PER_FIGURE * figures.length + MOST_BESIDES;
        cell = CELL;
        while (figures.length > 0 && !fill(width, height, most)) {
            cell *= 2;
        }
    }

    /** Fills the grid at the present cell size; false where it would grow beyond the most. */
    private boolean fill(double width, double height, long most) {
        if ((width / cell + 1) * (height / cell + 1) > most) {
            return false;
        }
        columns = (int) (width / cell) + 1;
        rows = (int) (height / cell) + 1;
        int[] counts = new int[columns * rows + 1];
        long total = 0;
        for (int i = 0; i < figures.length; i++) {
            total += visit(i, counts, null);
            if (total > most) {
                return false;
            }
        }
        starts = new int[counts.length];
        for (int i = 1; i < counts.length; i++) {
            starts[i] = starts[i - 1] + counts[i - 1];
        }
        entries = new int[(int) total];
        int[] next = starts.clone();
        for (int i = 0; i < figures.length; i++) {
            visit(i, next, entries);
        }
        return true;
    }

    /** Goes through the cells that a figure may touch, counting it there, and noting it where a counter points if there is a place to. */
    private int visit(int figure, int[] counters, int[] target) {
        Convex shape = figures[figure];
        Vec centre = shape.centre();
        double reach = shape.reach();
        int cells = 0;
        int lastRow = row(centre.y() + reach);
        int lastColumn = column(centre.x() + reach);
        for (int row = row(centre.y() - reach); row <= lastRow; row++) {
            for (int column = column(centre.x() - reach); column <= lastColumn; column++) {
                if (mayTouch(shape, column, row)) {
                    int at = row * columns + column;
                    if (target != null) {
                        target[counters[at]] = figure;
                    }
                    counters[at]++;
                    cells++;
                }
            }
        }
        return cells;
    }

    /** A long segment is kept out of the cells that only its enclosing circle touches. */
    private boolean mayTouch(Convex shape, int column, int row) {
        if (!(shape instanceof Segment segment)) {
            return true;
        }
        Vec middle = new Vec(left + (column + 0.5) * cell, bottom + (row + 0.5) * cell);
        return segment.nearestTo(middle).distanceTo(middle) <= 0.75 * cell;
    }

    private int column(double x) {
        return (int) Math.max(0, Math.min(columns - 1, Math.floor((x - left) / cell)));
    }

    private int row(double y) {
        return (int) Math.max(0, Math.min(rows - 1, Math.floor((y - bottom) / cell)));
    }

    @Override
    public void near(double x, double y, double distance, Candidates found) {
        if (figures.length == 0) {
            return;
        }
        startLook();
        int lastRow = row(y + distance);
        int firstColumn = column(x - distance);
        int lastColumn = column(x + distance);
        for (int row = row(y - distance); row <= lastRow; row++) {
            int end = starts[row * columns + lastColumn + 1];
            for (int entry = starts[row * columns + firstColumn]; entry < end; entry++) {
                int figure = entries[entry];
                if (lastSeen[figure] != look) {
                    lastSeen[figure] = look;
                    found.add(figures[figure], owners[figure]);
                }
            }
        }
    }

    private void startLook() {
        look++;
        if (look == 0) {
            Arrays.fill(lastSeen, 0);
            look = 1;
        }
    }
}
