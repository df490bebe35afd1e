package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.Arrays;

/**
 * Keeps every figure in the square cells that it may touch, so that a look around costs the same in a room of forty
 * walls as in one of forty thousand. Finds all that {@link BruteForceIndex} finds within the distance.
 */
final class GridIndex implements SpatialIndex {

    /** The side of a cell where the figures allow it, metres: about a third of what a robot looks round. */
    private static final double MIN_CELL_SIZE = 0.4;

    /** The grid is made coarser until it has no more entries and cells than this for each figure. */
    private static final int MAX_ENTRIES_PER_SHAPE = 16;

    private static final int MAX_ENTRIES_BASE = 4096;

    private final ConvexShape[] shapes;
    private final int[] owners;
    private final double left;
    private final double bottom;
    private double cellSize;
    private int columns;
    private int rows;
    private int[] starts = new int[0];
    private int[] entries = new int[0];
    private final int[] lastQuery;
    private int query;

    /** A grid over all figures of a list, which may be cleared afterwards. */
    GridIndex(CandidateBuffer all) {
        int size = all.size();
        shapes = new ConvexShape[size];
        owners = new int[size];
        lastQuery = new int[size];
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            shapes[i] = all.shape(i);
            owners[i] = all.owner(i);
            Vector2 centre = shapes[i].centre();
            double reach = shapes[i].boundingRadius();
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
        long most = (long) MAX_ENTRIES_PER_SHAPE * shapes.length + MAX_ENTRIES_BASE;
        cellSize = MIN_CELL_SIZE;
        while (shapes.length > 0 && !fill(width, height, most)) {
            cellSize *= 2;
        }
    }

    /** Fills the grid at the present cell size; false where it would grow beyond the most. */
    private boolean fill(double width, double height, long most) {
        if ((width / cellSize + 1) * (height / cellSize + 1) > most) {
            return false;
        }
        columns = (int) (width / cellSize) + 1;
        rows = (int) (height / cellSize) + 1;
        int[] counts = new int[columns * rows + 1];
        long total = 0;
        for (int i = 0; i < shapes.length; i++) {
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
        for (int i = 0; i < shapes.length; i++) {
            visit(i, next, entries);
        }
        return true;
    }

    /**
     * Goes through the cells that a figure may touch, counting it there, and noting it where a counter points if there
     * is a place to.
     */
    private int visit(int figure, int[] counters, int[] target) {
        ConvexShape shape = shapes[figure];
        Vector2 centre = shape.centre();
        double reach = shape.boundingRadius();
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
    private boolean mayTouch(ConvexShape shape, int column, int row) {
        if (!(shape instanceof Segment segment)) {
            return true;
        }
        Vector2 middle = new Vector2(left + (column + 0.5) * cellSize, bottom + (row + 0.5) * cellSize);
        return segment.nearestTo(middle).distanceTo(middle) <= 0.75 * cellSize;
    }

    private int column(double x) {
        return (int) Math.max(0, Math.min(columns - 1, Math.floor((x - left) / cellSize)));
    }

    private int row(double y) {
        return (int) Math.max(0, Math.min(rows - 1, Math.floor((y - bottom) / cellSize)));
    }

    @Override
    public void findNear(double x, double y, double distance, CandidateBuffer found) {
        if (shapes.length == 0) {
            return;
        }
        beginQuery();
        int lastRow = row(y + distance);
        int firstColumn = column(x - distance);
        int lastColumn = column(x + distance);
        for (int row = row(y - distance); row <= lastRow; row++) {
            int end = starts[row * columns + lastColumn + 1];
            for (int entry = starts[row * columns + firstColumn]; entry < end; entry++) {
                int figure = entries[entry];
                if (lastQuery[figure] != query) {
                    lastQuery[figure] = query;
                    found.add(shapes[figure], owners[figure]);
                }
            }
        }
    }

    private void beginQuery() {
        query++;
        if (query == 0) {
            Arrays.fill(lastQuery, 0);
            query = 1;
        }
    }
}
