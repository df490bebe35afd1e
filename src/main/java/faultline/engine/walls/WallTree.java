package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.SpatialIndex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;

/**
 * The walls of a world in a tree of boxes. A search looks at the nearest boxes first and ends at the first wall that it
 * accepts, so that it takes few steps among any number of walls. Boxes are divided when they are first searched. Of
 * many equal walls in a box, only one is kept.
 */
final class WallTree {

    /** The result of a search that has found nothing. */
    static final int NONE = -1;

    /** A box with no more walls is not divided. */
    private static final int MAX_UNDIVIDED = 4;

    /** The walls in the order of the boxes, and their numbers in the index. */
    private final ConvexShape[] walls;

    private final int[] numbers;
    /** For each number the next one of an equal wall that is not kept. */
    private final int[] nextEqual;

    /** For each box left, bottom, right and top, metres. */
    private double[] bounds = new double[256];
    /** The range of the walls of each box. */
    private int[] starts = new int[64];

    private int[] ends = new int[64];
    /** The first of the two parts of each box, 0 if it is not divided. */
    private int[] parts = new int[64];

    private int boxes;
    private long steps;

    WallTree(SpatialIndex index) {
        walls = new ConvexShape[index.size()];
        numbers = new int[index.size()];
        nextEqual = new int[index.size()];
        for (int i = 0; i < walls.length; i++) {
            walls[i] = index.shape(i);
            numbers[i] = i;
        }
        Arrays.fill(nextEqual, NONE);
        addBox(0, walls.length);
    }

    private void addBox(int from, int end) {
        if (boxes == starts.length) {
            bounds = Arrays.copyOf(bounds, 8 * boxes);
            starts = Arrays.copyOf(starts, 2 * boxes);
            ends = Arrays.copyOf(ends, 2 * boxes);
            parts = Arrays.copyOf(parts, 2 * boxes);
        }
        Extent extent = new Extent();
        for (int i = from; i < end; i++) {
            extent.addWall(walls[i]);
        }
        bounds[4 * boxes] = extent.left;
        bounds[4 * boxes + 1] = extent.bottom;
        bounds[4 * boxes + 2] = extent.right;
        bounds[4 * boxes + 3] = extent.top;
        starts[boxes] = from;
        ends[boxes++] = end;
    }

    /** Divides a box if it has many walls and is not divided yet, and returns whether it has parts. */
    private boolean isDivided(int box) {
        if (parts[box] == 0 && ends[box] - starts[box] > MAX_UNDIVIDED) {
            Extent centres = new Extent();
            for (int i = starts[box]; i < ends[box]; i++) {
                centres.add(walls[i].centre(), 0);
            }
            int middle = middle(box, centres);
            if (ends[box] - starts[box] > MAX_UNDIVIDED) {
                parts[box] = boxes;
                addBox(starts[box], middle);
                addBox(middle, ends[box]);
            }
        }
        return parts[box] != 0;
    }

    /** Sorts the walls of a box into two parts, and returns where the second one begins. */
    private int middle(int box, Extent centres) {
        boolean wide = centres.right - centres.left > centres.top - centres.bottom;
        if (!wide && centres.top == centres.bottom) {
            dropEqual(box);
            return (starts[box] + ends[box]) / 2;
        }
        double half = wide ? (centres.left + centres.right) / 2 : (centres.bottom + centres.top) / 2;
        int middle = starts[box];
        for (int i = starts[box]; i < ends[box]; i++) {
            Vector2 centre = walls[i].centre();
            if ((wide ? centre.x() : centre.y()) < half) {
                swap(i, middle++);
            }
        }
        return middle == starts[box] ? (middle + ends[box]) / 2 : middle;
    }

    /** Keeps one of each equal walls of a box. */
    private void dropEqual(int box) {
        Map<ConvexShape, Integer> last = new HashMap<>();
        int kept = starts[box];
        for (int i = starts[box]; i < ends[box]; i++) {
            Integer equal = last.put(walls[i], numbers[i]);
            if (equal == null) {
                swap(i, kept++);
            } else {
                nextEqual[equal] = numbers[i];
            }
        }
        ends[box] = kept;
    }

    private void swap(int one, int other) {
        ConvexShape wall = walls[one];
        walls[one] = walls[other];
        walls[other] = wall;
        int number = numbers[one];
        numbers[one] = numbers[other];
        numbers[other] = number;
    }

    ConvexShape wall(int index) {
        return walls[index];
    }

    /** Returns whether a wall stands for others that are equal. */
    boolean hasEqual(int index) {
        return nextEqual[numbers[index]] != NONE;
    }

    /** Returns the number of boxes and walls that all searches have looked at. */
    long steps() {
        return steps;
    }

    /**
     * Returns a wall that passes a test, {@link #NONE} if none within a radius of a point does.
     *
     * @param point the point
     * @param radius metres
     * @param test takes the index of a wall, which may be farther away
     */
    int find(Vector2 point, double radius, IntPredicate test) {
        return find(0, toBox(0, point), point, radius + WallReference.ROUNDING, test);
    }

    private int find(int box, double toBox, Vector2 point, double reach, IntPredicate test) {
        steps++;
        if (toBox > reach) {
            return NONE;
        }
        if (!isDivided(box)) {
            return findUndivided(box, test);
        }
        double toFirst = toBox(parts[box], point);
        double toSecond = toBox(parts[box] + 1, point);
        int near = toSecond < toFirst ? parts[box] + 1 : parts[box];
        int found = find(near, Math.min(toFirst, toSecond), point, reach, test);
        int far = 2 * parts[box] + 1 - near;
        return found != NONE ? found : find(far, Math.max(toFirst, toSecond), point, reach, test);
    }

    private int findUndivided(int box, IntPredicate test) {
        for (int i = starts[box]; i < ends[box]; i++) {
            steps++;
            if (test.test(i)) {
                return i;
            }
        }
        return NONE;
    }

    /** Returns the distance of a point from a box, metres; 0 inside. */
    private double toBox(int box, Vector2 point) {
        double dx = Math.max(0, Math.max(bounds[4 * box] - point.x(), point.x() - bounds[4 * box + 2]));
        double dy = Math.max(0, Math.max(bounds[4 * box + 1] - point.y(), point.y() - bounds[4 * box + 3]));
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** The smallest box around some walls or points. */
    private static final class Extent {

        private double left = Double.POSITIVE_INFINITY;
        private double bottom = Double.POSITIVE_INFINITY;
        private double right = Double.NEGATIVE_INFINITY;
        private double top = Double.NEGATIVE_INFINITY;

        void addWall(ConvexShape wall) {
            if (wall instanceof Segment segment) {
                add(segment.a(), 0);
                add(segment.b(), 0);
            } else {
                add(wall.centre(), wall.boundingRadius());
            }
        }

        void add(Vector2 centre, double radius) {
            left = Math.min(left, centre.x() - radius);
            bottom = Math.min(bottom, centre.y() - radius);
            right = Math.max(right, centre.x() + radius);
            top = Math.max(top, centre.y() + radius);
        }
    }

    /** The walls of the tree that have not been taken yet. */
    final class Untaken {

        private final BitSet taken = new BitSet();
        /** The boxes of which all walls have been taken. */
        private final BitSet empty = new BitSet();

        /** Takes the walls within a radius of a point, metres, and returns their numbers. */
        List<Integer> take(Vector2 point, double radius) {
            List<Integer> found = new ArrayList<>();
            take(0, point, radius, found);
            return found;
        }

        private void take(int box, Vector2 point, double radius, List<Integer> found) {
            steps++;
            if (empty.get(box) || toBox(box, point) > radius + WallReference.ROUNDING) {
                return;
            }
            if (isDivided(box)) {
                take(parts[box], point, radius, found);
                take(parts[box] + 1, point, radius, found);
                empty.set(box, empty.get(parts[box]) && empty.get(parts[box] + 1));
                return;
            }
            for (int i = starts[box]; i < ends[box]; i++) {
                if (!taken.get(numbers[i]) && walls[i].distanceTo(point.x(), point.y()) <= radius) {
                    for (int number = numbers[i]; number != NONE; number = nextEqual[number]) {
                        taken.set(number);
                        found.add(number);
                    }
                }
            }
            empty.set(box, isTaken(box));
        }

        private boolean isTaken(int box) {
            for (int i = starts[box]; i < ends[box]; i++) {
                if (!taken.get(numbers[i])) {
                    return false;
                }
            }
            return true;
        }
    }
}
