package faultline.floorplan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Traces the outlines of solid cells exactly. Each side of a solid cell that is not shared with a solid neighbour
 * belongs to one ring, with the solid on its left. If two cells touch only at a corner, the ring turns left, so each
 * cell has a separate outline. Filling all rings by the even-odd rule restores the cells.
 */
public final class OutlineTracer {

    private static final int EAST = 0;
    private static final int NORTH = 1;
    private static final int WEST = 2;
    private static final int SOUTH = 3;
    private static final int[] COLUMN_STEP = {1, 0, -1, 0};
    private static final int[] ROW_STEP = {0, 1, 0, -1};

    private final int stride;
    /** For each corner of a cell, a bit for each direction in which an untraced side leaves it. */
    private final byte[] sides;

    private int[] columns = new int[64];
    private int[] rows = new int[64];
    private int size;

    private OutlineTracer(SolidCells cells) {
        stride = cells.width() + 1;
        sides = new byte[stride * (cells.height() + 1)];
        for (int row = 0; row < cells.height(); row++) {
            for (int column = 0; column < cells.width(); column++) {
                if (cells.isSolid(column, row)) {
                    addSides(cells, column, row);
                }
            }
        }
    }

    /**
     * {@return the outlines of all solid cells, ordered by their lowest and then leftmost corner}
     *
     * @param cells the solid cells
     */
    public static List<GridRing> trace(SolidCells cells) {
        return new OutlineTracer(cells).traceAll();
    }

    private void addSides(SolidCells cells, int column, int row) {
        if (!cells.isSolid(column, row - 1)) {
            addSide(column, row, EAST);
        }
        if (!cells.isSolid(column + 1, row)) {
            addSide(column + 1, row, NORTH);
        }
        if (!cells.isSolid(column, row + 1)) {
            addSide(column + 1, row + 1, WEST);
        }
        if (!cells.isSolid(column - 1, row)) {
            addSide(column, row + 1, SOUTH);
        }
    }

    private void addSide(int column, int row, int direction) {
        sides[row * stride + column] |= (byte) (1 << direction);
    }

    private List<GridRing> traceAll() {
        List<GridRing> rings = new ArrayList<>();
        for (int corner = 0; corner < sides.length; corner++) {
            while (sides[corner] != 0) {
                rings.add(traceRing(corner % stride, corner / stride));
            }
        }
        return rings;
    }

    private GridRing traceRing(int startColumn, int startRow) {
        size = 0;
        int column = startColumn;
        int row = startRow;
        int direction = Integer.numberOfTrailingZeros(sides[row * stride + column]);
        int previous = -1;
        while (direction >= 0) {
            if (direction != previous) {
                addCorner(column, row);
            }
            sides[row * stride + column] &= (byte) ~(1 << direction);
            column += COLUMN_STEP[direction];
            row += ROW_STEP[direction];
            previous = direction;
            direction = nextDirection(column, row, direction);
        }
        return new GridRing(Arrays.copyOf(columns, size), Arrays.copyOf(rows, size));
    }

    /** Returns the direction of the side that continues a ring: left before straight before right; -1 at its end. */
    private int nextDirection(int column, int row, int direction) {
        int here = sides[row * stride + column];
        for (int turn = 1; turn >= -1; turn--) {
            int next = Math.floorMod(direction + turn, 4);
            if ((here & 1 << next) != 0) {
                return next;
            }
        }
        return -1;
    }

    private void addCorner(int column, int row) {
        if (size == columns.length) {
            columns = Arrays.copyOf(columns, 2 * size);
            rows = Arrays.copyOf(rows, 2 * size);
        }
        columns[size] = column;
        rows[size++] = row;
    }
}
