package faultline.engine.walls;

import faultline.geometry.Vector2;

/** Numbers the square cells of a plane, as keys of {@link CellNumbers}. */
final class CellKey {

    private CellKey() {}

    /** Returns the column or row of a coordinate in cells of a side, both in metres. */
    static long index(double coordinate, double size) {
        return (long) Math.floor(coordinate / size);
    }

    /** Returns the number of the cell of a point in cells of a side, metres. */
    static long of(Vector2 point, double size) {
        return of(index(point.x(), size), index(point.y(), size));
    }

    /** Returns the number of a cell; no two cells within 2^31 rows and columns of the origin have the same. */
    static long of(long column, long row) {
        return column << Integer.SIZE | row & 0xFFFF_FFFFL;
    }
}
