package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.SectorDistance;
import faultline.geometry.Segment;
import faultline.geometry.SpecularDistance;
import java.util.Arrays;

/**
 * The shapes that one sensor may see while the robot stays near a pose, by ascending distance from the sensor at that
 * pose, so that a reading ends at the first shape that is certainly farther. Reused without allocation.
 */
final class NearShapes {

    /** A shape with the numbers that a reading needs. */
    private static final class NearShape {
        private ConvexShape shape;
        private double tangent;
        private boolean mattSegment;
        private double ax;
        private double ay;
        private double dx;
        private double dy;

        private void set(ConvexShape newShape, double newTangent) {
            shape = newShape;
            tangent = newTangent;
            mattSegment = false;
            if (newShape instanceof Segment segment && newTangent == Double.POSITIVE_INFINITY) {
                mattSegment = true;
                ax = segment.ax();
                ay = segment.ay();
                dx = segment.bx() - segment.ax();
                dy = segment.by() - segment.ay();
            }
        }
    }

    private NearShape[] entries = new NearShape[0];
    /**
     * For each entry the bits of its distance as a float, rounded down, and its index in the lower half. A sort of
     * numbers allocates nothing.
     */
    private long[] keys = new long[0];

    private int size;

    void clear() {
        size = 0;
    }

    boolean isEmpty() {
        return size == 0;
    }

    /**
     * Adds a shape with the tangent of the greatest angle of incidence at which it is sensed, positive infinity for
     * all, and its distance from the sensor at the pose, metres.
     */
    void add(ConvexShape shape, double tangent, double distance) {
        if (size == entries.length) {
            entries = Arrays.copyOf(entries, 2 * size + 4);
            keys = Arrays.copyOf(keys, entries.length);
            for (int i = size; i < entries.length; i++) {
                entries[i] = new NearShape();
            }
        }
        entries[size].set(shape, tangent);
        keys[size] = key(distance, size);
        size++;
    }

    /**
     * Returns the bits of a float that is not above a distance, and an index. The bits of floats that are not negative
     * have the same order as the floats.
     */
    private static long key(double distance, int index) {
        float bound = Math.max(0, Math.nextDown((float) distance));
        return (long) Float.floatToRawIntBits(bound) << Integer.SIZE | index;
    }

    private static float distance(long key) {
        return Float.intBitsToFloat((int) (key >>> Integer.SIZE));
    }

    /** Must be called when all shapes have been added. */
    void sort() {
        Arrays.sort(keys, 0, size);
    }

    /**
     * Returns the distance to the nearest shape in a sector, metres, or positive infinity.
     *
     * @param sector the cone of the sensor
     * @param moved the distance that the sensor has moved from where it was at the pose, or more, metres
     */
    double nearest(SectorDistance sector, double moved) {
        double least = Double.POSITIVE_INFINITY;
        double limit = sector.range() + moved;
        for (int i = 0; i < size && distance(keys[i]) <= limit; i++) {
            NearShape entry = entries[(int) keys[i]];
            double distance = entry.mattSegment
                    ? sector.toSegment(entry.ax, entry.ay, entry.dx, entry.dy)
                    : nearest(sector, entry.shape, entry.tangent);
            if (distance < least) {
                least = distance;
                limit = least + moved;
            }
        }
        return least;
    }

    /** Returns the distance to one shape in a sector, metres, or positive infinity. */
    static double nearest(SectorDistance sector, ConvexShape shape, double tangent) {
        return tangent < Double.POSITIVE_INFINITY && shape instanceof Segment segment
                ? SpecularDistance.nearest(sector, segment, tangent)
                : sector.nearest(shape);
    }
}
