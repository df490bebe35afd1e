package faultline.engine.metrics;

import faultline.geometry.Vector2;

/** Numbers the square cells of a plane, for hash maps. */
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

    /** Returns the number of a cell. Two cells have the same number so rarely that only time is lost by it. */
    static long of(long column, long row) {
        return column * 0x9E3779B97F4A7C15L ^ row * 0xC2B2AE3D27D4EB4FL;
    }
}
