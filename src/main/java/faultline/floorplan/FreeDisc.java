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

    /**
     * A value greater than every squared distance in a map, and small enough that sums with squared distances are
     * exact.
     */
    private static final double FAR = 1e12;

    /**
     * Finds the largest free disc with an exact Euclidean distance transform (Felzenszwalb and Huttenlocher, 2012), in
     * time linear in the number of cells.
     *
     * @param grid the map; unknown cells are not free
     * @param solid the cells that obstruct the robot
     * @return the largest disc; the lowest and then leftmost of several. Its clearance is 0 if no cell is free
     */
    public static FreeDisc largest(OccupancyGrid grid, SolidCells solid) {
        int width = grid.width() + 2;
        int height = grid.height() + 2;
        double[] squared = new double[width * height];
        for (int row = 0; row < grid.height(); row++) {
            for (int column = 0; column < grid.width(); column++) {
                boolean free = grid.state(column, row) != CellState.UNKNOWN && !solid.isSolid(column, row);
                squared[(row + 1) * width + column + 1] = free ? FAR : 0;
            }
        }
        DistanceTransform transform = new DistanceTransform(Math.max(width, height));
        for (int column = 0; column < width; column++) {
            transform.apply(squared, column, width, height);
        }
        for (int row = 0; row < height; row++) {
            transform.apply(squared, row * width, 1, width);
        }
        int best = 0;
        for (int i = 1; i < squared.length; i++) {
            best = squared[i] > squared[best] ? i : best;
        }
        return new FreeDisc(Math.max(0, best % width - 1), Math.max(0, best / width - 1), Math.sqrt(squared[best]));
    }

    /** The one-dimensional transform: the lower envelope of one parabola per sample. */
    private static final class DistanceTransform {
        private final int[] vertices;
        private final double[] borders;
        private final double[] values;

        DistanceTransform(int longest) {
            vertices = new int[longest];
            borders = new double[longest + 1];
            values = new double[longest];
        }

        void apply(double[] data, int offset, int step, int count) {
            for (int i = 0; i < count; i++) {
                values[i] = data[offset + i * step];
            }
            int last = 0;
            vertices[0] = 0;
            borders[0] = -FAR;
            borders[1] = FAR;
            for (int i = 1; i < count; i++) {
                double border = intersection(i, vertices[last]);
                while (border <= borders[last]) {
                    border = intersection(i, vertices[--last]);
                }
                vertices[++last] = i;
                borders[last] = border;
                borders[last + 1] = FAR;
            }
            int at = 0;
            for (int i = 0; i < count; i++) {
                while (borders[at + 1] < i) {
                    at++;
                }
                double d = i - vertices[at];
                data[offset + i * step] = d * d + values[vertices[at]];
            }
        }

        private double intersection(int i, int j) {
            return (values[i] + (double) i * i - (values[j] + (double) j * j)) / (2.0 * (i - j));
        }
    }
}
