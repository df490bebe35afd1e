package faultline.engine.walls;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Points by the square cells in which they lie, so that only those of the nearest cells are compared with a place. */
final class PointCells {

    private final double size;
    private final List<Vector2> points = new ArrayList<>();
    /** The last point of each cell, and for each point the one before it in its cell. */
    private final CellNumbers last = new CellNumbers();

    private int[] before = new int[64];

    /** Creates a list without points, with cells of a side, metres. */
    PointCells(double size) {
        this.size = size;
    }

    void add(Vector2 point) {
        int number = points.size();
        if (number == before.length) {
            before = Arrays.copyOf(before, 2 * number);
        }
        long cell = CellKey.of(point, size);
        before[number] = last.get(cell);
        last.put(cell, number);
        points.add(point);
    }

    /** Returns the points in the order in which they were added. */
    List<Vector2> points() {
        return points;
    }

    /** Removes all points. */
    void clear() {
        points.clear();
        last.clear();
    }

    /** Returns whether a point is no farther from a place than a radius, metres, less than the side of a cell. */
    boolean isNear(Vector2 place, double radius) {
        long column = CellKey.index(place.x(), size);
        long row = CellKey.index(place.y(), size);
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                if (isNear(place, radius, last.get(CellKey.of(column + dx, row + dy)))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Returns whether a point of a cell, the last of which is given, is no farther from a place than a radius. */
    private boolean isNear(Vector2 place, double radius, int lastOfCell) {
        for (int number = lastOfCell; number != CellNumbers.NONE; number = before[number]) {
            if (points.get(number).distanceTo(place) <= radius) {
                return true;
            }
        }
        return false;
    }
}
