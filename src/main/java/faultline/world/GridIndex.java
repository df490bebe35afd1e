package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.Arrays;

/**
 * Keeps every shape in the square cells that its bounding box touches, so that a query costs the same among forty walls
 * as among forty thousand. Finds all that {@link BruteForceIndex} finds within the distance.
 */
final class GridIndex implements SpatialIndex {

    /** The side of a cell if the shapes allow it, metres: about a third of the distance that a robot senses. */
    private static final double MIN_CELL_SIZE = 0.4;

    /** The grid is made coarser until it has no more entries and cells than this for each shape. */
    private static final int MAX_ENTRIES_PER_SHAPE = 16;

    private static final int MAX_ENTRIES_BASE = 4096;

    /** A segment whose box touches more cells than this is kept only in those that it may touch itself. */
    private static final int MAX_BOX_CELLS = 4;

    /** A segment that is farther than this from the centre of a cell, in sides, does not touch it. */
    private static final double TOUCH_RADIUS = 0.75;

    /** The radius and one cell more than rounding needs, in sides of a cell. */
    private static final double COLUMN_MARGIN = TOUCH_RADIUS + 1;

    /** In a box with more columns than this, only those that the segment crosses are tested in each row. */
    private static final int MAX_TESTED_COLUMNS = 8;

    private final ConvexShape[] shapes;
    private final ShapeOwner[] owners;
    private final double[] minX;
    private final double[] minY;
    private final double[] maxX;
    private final double[] maxY;
    private double left = Double.POSITIVE_INFINITY;
    private double bottom = Double.POSITIVE_INFINITY;
    private double cellSize;
    private int columns;
    private int rows;
    private int[] starts = new int[0];
    private int[] entries = new int[0];
    private final int[] lastQuery;
    private int query;

    GridIndex(CandidateBuffer all) {
        int size = all.size();
        shapes = all.shapes();
        owners = all.owners();
        lastQuery = new int[size];
        minX = new double[size];
        minY = new double[size];
        maxX = new double[size];
        maxY = new double[size];
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            setBox(i, shapes[i]);
            left = minX[i] < left ? minX[i] : left;
            bottom = minY[i] < bottom ? minY[i] : bottom;
            right = maxX[i] > right ? maxX[i] : right;
            top = maxY[i] > top ? maxY[i] : top;
        }
        build(right - left, top - bottom);
    }

    /** Creates a copy that shares everything but the marks of its queries. */
    private GridIndex(GridIndex other) {
        shapes = other.shapes;
        owners = other.owners;
        minX = other.minX;
        minY = other.minY;
        maxX = other.maxX;
        maxY = other.maxY;
        left = other.left;
        bottom = other.bottom;
        cellSize = other.cellSize;
        columns = other.columns;
        rows = other.rows;
        starts = other.starts;
        entries = other.entries;
        lastQuery = new int[shapes.length];
    }

    private void setBox(int i, ConvexShape shape) {
        if (shape instanceof Segment segment) {
            boolean rightwards = segment.ax() < segment.bx();
            boolean upwards = segment.ay() < segment.by();
            minX[i] = rightwards ? segment.ax() : segment.bx();
            minY[i] = upwards ? segment.ay() : segment.by();
            maxX[i] = rightwards ? segment.bx() : segment.ax();
            maxY[i] = upwards ? segment.by() : segment.ay();
        } else {
            Vector2 centre = shape.centre();
            double radius = shape.boundingRadius() * (1 + 1e-12);
            minX[i] = centre.x() - radius;
            minY[i] = centre.y() - radius;
            maxX[i] = centre.x() + radius;
            maxY[i] = centre.y() + radius;
        }
    }

    private void build(double width, double height) {
        long max = (long) MAX_ENTRIES_PER_SHAPE * shapes.length + MAX_ENTRIES_BASE;
        cellSize = MIN_CELL_SIZE;
        while (shapes.length > 0 && !fill(width, height, max)) {
            cellSize *= 2;
        }
    }

    /** Fills the grid at the current cell size, and returns false if it would have more entries than allowed. */
    private boolean fill(double width, double height, long max) {
        if ((width / cellSize + 1) * (height / cellSize + 1) > max) {
            return false;
        }
        columns = (int) (width / cellSize) + 1;
        rows = (int) (height / cellSize) + 1;
        int[] counts = new int[columns * rows + 1];
        long total = 0;
        for (int i = 0; i < shapes.length; i++) {
            total += visit(i, counts, null);
            if (total > max) {
                return false;
            }
        }
        starts = new int[counts.length];
        for (int i = 1; i < counts.length; i++) {
            starts[i] = starts[i - 1] + counts[i - 1];
        }
        entries = new int[(int) total];
        // The counts have been used; from here on, they are the places of the next entries.
        System.arraycopy(starts, 0, counts, 0, counts.length);
        for (int i = 0; i < shapes.length; i++) {
            visit(i, counts, entries);
        }
        return true;
    }

    /**
     * Visits the cells that a shape may touch, and increments their counters. If there are entries, first writes the
     * shape to where the counter points.
     */
    private int visit(int shape, int[] counters, int[] target) {
        int firstRow = row(minY[shape]);
        int lastRow = row(maxY[shape]);
        int firstColumn = column(minX[shape]);
        int lastColumn = column(maxX[shape]);
        boolean testCells = (lastRow - firstRow + 1L) * (lastColumn - firstColumn + 1L) > MAX_BOX_CELLS
                && shapes[shape] instanceof Segment;
        if (testCells && lastColumn - firstColumn >= MAX_TESTED_COLUMNS && firstRow < lastRow) {
            return visitCrossed(shape, counters, target);
        }
        int cells = 0;
        for (int row = firstRow; row <= lastRow; row++) {
            cells += visitRow(shape, row, firstColumn, lastColumn, testCells, counters, target);
        }
        return cells;
    }

    /** Visits the same cells for a long segment in several rows, but tests only those near it in each row. */
    private int visitCrossed(int shape, int[] counters, int[] target) {
        Segment segment = (Segment) shapes[shape];
        int firstColumn = column(minX[shape]);
        int lastColumn = column(maxX[shape]);
        int lastRow = row(maxY[shape]);
        int cells = 0;
        for (int row = row(minY[shape]); row <= lastRow; row++) {
            double atBottom = xAt(segment, bottom + (row + 0.5 - TOUCH_RADIUS) * cellSize);
            double atTop = xAt(segment, bottom + (row + 0.5 + TOUCH_RADIUS) * cellSize);
            int from = column(Math.min(atBottom, atTop) - COLUMN_MARGIN * cellSize);
            int to = column(Math.max(atBottom, atTop) + COLUMN_MARGIN * cellSize);
            cells +=
                    visitRow(shape, row, Math.max(firstColumn, from), Math.min(lastColumn, to), true, counters, target);
        }
        return cells;
    }

    private int visitRow(int shape, int row, int from, int to, boolean testCells, int[] counters, int[] target) {
        int cells = 0;
        for (int column = from; column <= to; column++) {
            if (!testCells || mayTouch(shape, column, row)) {
                int cell = row * columns + column;
                if (target != null) {
                    target[counters[cell]] = shape;
                }
                counters[cell]++;
                cells++;
            }
        }
        return cells;
    }

    private boolean mayTouch(int shape, int column, int row) {
        double x = left + (column + 0.5) * cellSize;
        double y = bottom + (row + 0.5) * cellSize;
        return shapes[shape].distanceTo(x, y) <= TOUCH_RADIUS * cellSize;
    }

    /** Returns x where a segment that is not horizontal crosses y, or x of its end nearer to that. */
    private static double xAt(Segment segment, double y) {
        double share = (y - segment.ay()) / (segment.by() - segment.ay());
        return segment.ax() + Math.max(0, Math.min(1, share)) * (segment.bx() - segment.ax());
    }

    private int column(double x) {
        int column = (int) ((x - left) / cellSize);
        return column < 0 ? 0 : column < columns ? column : columns - 1;
    }

    private int row(double y) {
        int row = (int) ((y - bottom) / cellSize);
        return row < 0 ? 0 : row < rows ? row : rows - 1;
    }

    @Override
    public int size() {
        return shapes.length;
    }

    @Override
    public ConvexShape shape(int number) {
        return shapes[number];
    }

    @Override
    public SpatialIndex copy() {
        return new GridIndex(this);
    }

    @Override
    public void findNear(double x, double y, double distance, CandidateBuffer found) {
        if (shapes.length == 0) {
            return;
        }
        beginQuery();
        int endRow = row(y + distance) + 1;
        int firstColumn = column(x - distance);
        int endColumn = column(x + distance) + 1;
        for (int row = row(y - distance); row < endRow; row++) {
            addEntries(starts[row * columns + firstColumn], starts[row * columns + endColumn], found);
        }
    }

    /** Adds the shapes of some entries that the present query has not added yet. */
    private void addEntries(int from, int end, CandidateBuffer found) {
        for (int entry = from; entry < end; entry++) {
            int shape = entries[entry];
            if (lastQuery[shape] != query) {
                lastQuery[shape] = query;
                found.add(shapes[shape], owners[shape], shape);
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
