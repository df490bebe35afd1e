package faultline.floorplan;

/**
 * The largest disc of free cells in a map, which is a good place to start from.
 *
 * @param column the column of its middle cell
 * @param row the row of its middle cell, from the bottom
 * @param clearance the distance from the middle of that cell to the middle of the nearest cell that is not free, in
 *     cells; cells beyond the map are not free
 */
public record FreeDisc(int column, int row, double clearance) {

    /** A value beyond every border between two parabolas, in cells. */
    private static final double FAR = 1e12;

    /**
     * Finds the largest free disc with an exact Euclidean distance transform (Felzenszwalb and Huttenlocher, 2012), in
     * time linear in the number of cells.
     *
     * @param grid the map
     * @param solid the cells that obstruct the robot
     * @param unknownIsFree whether unknown cells that are not solid are free
     * @return the largest disc; the lowest and then leftmost of several. Its clearance is 0 if no cell is free
     */
    public static FreeDisc largest(OccupancyGrid grid, SolidCells solid, boolean unknownIsFree) {
        int width = grid.width() + 2;
        short[] distances = columnDistances(grid, solid, unknownIsFree);
        DistanceTransform transform = new DistanceTransform(width);
        FreeDisc best = new FreeDisc(0, 0, 0);
        double bestSquared = 0;
        for (int row = 0; row < grid.height(); row++) {
            double largest = 0;
            for (int column = 0; column < grid.width(); column++) {
                double distance = distances[row * grid.width() + column];
                transform.set(column + 1, distance * distance);
                largest = Math.max(largest, distance * distance);
            }
            if (largest <= bestSquared) {
                // No disc is larger than the distances in its own column.
                continue;
            }
            transform.apply();
            for (int column = 0; column < grid.width(); column++) {
                double squared = transform.get(column + 1);
                if (squared > bestSquared) {
                    bestSquared = squared;
                    best = new FreeDisc(column, row, Math.sqrt(squared));
                }
            }
        }
        return best;
    }

    /**
     * Returns for each cell the distance to the nearest cell of its column that is not free. Greater distances than the
     * map is wide are cut off there: the cells beyond its sides are nearer.
     */
    private static short[] columnDistances(OccupancyGrid grid, SolidCells solid, boolean unknownIsFree) {
        int width = grid.width();
        short[] distances = new short[width * grid.height()];
        short limit = (short) Math.min(width, Short.MAX_VALUE - 1);
        for (int i = 0; i < distances.length; i++) {
            boolean free = (unknownIsFree || grid.state(i % width, i / width) != CellState.UNKNOWN)
                    && !solid.isSolid(i % width, i / width);
            int below = i < width ? 0 : distances[i - width];
            distances[i] = (short) (free ? Math.min(limit, below + 1) : 0);
        }
        for (int i = distances.length - 1; i >= 0; i--) {
            int above = i + width < distances.length ? distances[i + width] : 0;
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
