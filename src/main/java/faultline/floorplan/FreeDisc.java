package faultline.floorplan;

/**
 * A large disc of free cells in a map, which is a good place to start from. Cells beyond the map are not free.
 *
 * @param x the centre, in cells from the left side
 * @param y the centre, in cells from the lower side
 * @param clearance its radius in cells; about the middle of a cell, the distance to the middle of the nearest cell that
 *     is not free; 0 if there is no disc
 */
public record FreeDisc(double x, double y, double clearance) {

    /** A value beyond every border between two parabolas, in cells. */
    private static final double FAR = 1e12;

    /** Returns whether a place of a lattice is free. */
    private interface Lattice {
        boolean isFree(int column, int row);
    }

    /**
     * Finds the cell that is farthest from all cells that are not free, from middle to middle.
     *
     * @param grid the map
     * @param solid the cells that obstruct the robot
     * @param unknownIsFree whether unknown cells that are not solid are free
     * @return the disc about its middle; of several cells, the lowest and then leftmost
     */
    public static FreeDisc aboutCell(OccupancyGrid grid, SolidCells solid, boolean unknownIsFree) {
        return largest(grid.width(), grid.height(), cells(grid, solid, unknownIsFree), 0.5);
    }

    /**
     * Finds the largest free disc about a corner of cells. In a corridor of an even number of cells it is larger than
     * any about the middle of a cell.
     *
     * @param grid the map
     * @param solid the cells that obstruct the robot
     * @param unknownIsFree whether unknown cells that are not solid are free
     * @return the largest disc; of several, the lowest and then leftmost
     */
    public static FreeDisc aboutCorner(OccupancyGrid grid, SolidCells solid, boolean unknownIsFree) {
        Lattice cells = cells(grid, solid, unknownIsFree);
        return largest(
                grid.width() - 1,
                grid.height() - 1,
                (column, row) -> cells.isFree(column, row)
                        && cells.isFree(column + 1, row)
                        && cells.isFree(column, row + 1)
                        && cells.isFree(column + 1, row + 1),
                1);
    }

    private static Lattice cells(OccupancyGrid grid, SolidCells solid, boolean unknownIsFree) {
        return (column, row) ->
                (unknownIsFree || grid.state(column, row) != CellState.UNKNOWN) && !solid.isSolid(column, row);
    }

    /**
     * Finds the place of a lattice that is farthest from all that are not free, as are those beyond its border, with an
     * exact Euclidean distance transform (Felzenszwalb and Huttenlocher, 2012), in time linear in the number of places.
     */
    private static FreeDisc largest(int columns, int rows, Lattice lattice, double offset) {
        short[] distances = columnDistances(columns, rows, lattice);
        DistanceTransform transform = new DistanceTransform(columns + 2);
        FreeDisc best = new FreeDisc(offset, offset, 0);
        double bestSquared = 0;
        for (int row = 0; row < rows; row++) {
            double largest = 0;
            for (int column = 0; column < columns; column++) {
                double distance = distances[row * columns + column];
                transform.set(column + 1, distance * distance);
                largest = Math.max(largest, distance * distance);
            }
            if (largest <= bestSquared) {
                // No disc is larger than the distances in its own column.
                continue;
            }
            transform.apply();
            for (int column = 0; column < columns; column++) {
                double squared = transform.get(column + 1);
                if (squared > bestSquared) {
                    bestSquared = squared;
                    best = new FreeDisc(column + offset, row + offset, Math.sqrt(squared));
                }
            }
        }
        return best;
    }

    /**
     * Returns for each place the distance to the nearest place of its column that is not free. Greater distances than
     * the lattice is wide are cut off there: the places beyond its sides are nearer.
     */
    private static short[] columnDistances(int columns, int rows, Lattice lattice) {
        short[] distances = new short[columns * rows];
        short limit = (short) Math.min(columns, Short.MAX_VALUE - 1);
        for (int i = 0; i < distances.length; i++) {
            int below = i < columns ? 0 : distances[i - columns];
            distances[i] = (short) (lattice.isFree(i % columns, i / columns) ? Math.min(limit, below + 1) : 0);
        }
        for (int i = distances.length - 1; i >= 0; i--) {
            int above = i + columns < distances.length ? distances[i + columns] : 0;
            distances[i] = (short) Math.min(distances[i], above + 1);
        }
        return distances;
    }

    /** The one-dimensional transform: the lower envelope of one parabola per sample. */
    private static final class DistanceTransform {
        private final int[] vertices;
        private final double[] borders;
        private final double[] values;
        private final double[] results;

        /** Creates a transform of samples that are 0 until they are set. */
        DistanceTransform(int count) {
            vertices = new int[count];
            borders = new double[count + 1];
            values = new double[count];
            results = new double[count];
        }

        void set(int index, double value) {
            values[index] = value;
        }

        double get(int index) {
            return results[index];
        }

        void apply() {
            int last = 0;
            vertices[0] = 0;
            borders[0] = -FAR;
            borders[1] = FAR;
            for (int i = 1; i < values.length; i++) {
                double border = intersection(i, vertices[last]);
                while (border <= borders[last]) {
                    border = intersection(i, vertices[--last]);
                }
                vertices[++last] = i;
                borders[last] = border;
                borders[last + 1] = FAR;
            }
            int at = 0;
            for (int i = 0; i < values.length; i++) {
                while (borders[at + 1] < i) {
                    at++;
                }
                double d = i - vertices[at];
                results[i] = d * d + values[vertices[at]];
            }
        }

        private double intersection(int i, int j) {
            return (values[i] + (double) i * i - (values[j] + (double) j * j)) / (2.0 * (i - j));
        }
    }
}
