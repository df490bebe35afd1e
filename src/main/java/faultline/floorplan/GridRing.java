package faultline.floorplan;

import java.util.Arrays;

/**
 * A closed outline through corners of cells, with the solid side on the left. The last corner is joined to the first.
 * Immutable.
 */
public final class GridRing {

    private final int[] columns;
    private final int[] rows;

    /** Takes over the corners' coordinates, in cells from the lower left corner of the map. */
    GridRing(int[] columns, int[] rows) {
        this.columns = columns;
        this.rows = rows;
    }

    /** {@return the number of corners} */
    public int size() {
        return columns.length;
    }

    /**
     * {@return the distance of a corner from the left side of the map, in cells}
     *
     * @param corner the index of the corner
     */
    public int column(int corner) {
        return columns[corner];
    }

    /**
     * {@return the distance of a corner from the bottom of the map, in cells}
     *
     * @param corner the index of the corner
     */
    public int row(int corner) {
        return rows[corner];
    }

    /** Returns the ring through some of these corners, by their ascending indexes. */
    GridRing select(int[] corners) {
        int[] x = Arrays.stream(corners).map(i -> columns[i]).toArray();
        int[] y = Arrays.stream(corners).map(i -> rows[i]).toArray();
        return new GridRing(x, y);
    }
}
