package faultline.engine.metrics;

import faultline.geometry.Vector2;

/** Numbers the square cells of a plane, for hash maps. */
final class CellKey {

    private CellKey() {}

    /**
     * Returns the number of a cell. Two cells have the same number so rarely that only time is lost by it.
     *
     * @param point a point
     * @param size the side of a cell, metres
     * @param dx the cell is this many columns to the right of that of the point
     * @param dy the cell is this many rows above that of the point
     */
    static long of(Vector2 point, double size, int dx, int dy) {
        long column = (long) Math.floor(point.x() / size) + dx;
        long row = (long) Math.floor(point.y() / size) + dy;
        return column * 0x9E3779B97F4A7C15L ^ row * 0xC2B2AE3D27D4EB4FL;
    }
}
