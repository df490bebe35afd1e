package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.SectorDistance;
import faultline.geometry.Segment;
import faultline.geometry.SpecularDistance;
import java.util.Arrays;
import java.util.Comparator;

/**
 * The shapes that one sensor may see while the robot stays near a pose, by ascending lower bound of their distances, so
 * that a reading ends at the first shape that is certainly farther. Reused without allocation.
 */
final class NearShapes {

    /** A shape with the numbers that a reading needs. */
    private static final class NearShape {
        private double lowerBound;
        private ConvexShape shape;
        private double tangent;
        private boolean mattSegment;
        private double ax;
        private double ay;
        private double dx;
        private double dy;

        private void set(ConvexShape newShape, double newTangent, double newBound) {
            lowerBound = newBound;
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

    private static final Comparator<NearShape> BY_LOWER_BOUND = Comparator.comparingDouble(entry -> entry.lowerBound);

    private NearShape[] entries = new NearShape[0];
    private int size;

    void clear() {
        size = 0;
    }

    boolean isEmpty() {
        return size == 0;
    }

    /**
     * Adds a shape with the tangent of the greatest angle of incidence at which it is sensed, positive infinity for
     * all, and a lower bound of its distance, metres.
     */
    void add(ConvexShape shape, double tangent, double lowerBound) {
        if (size == entries.length) {
            entries = Arrays.copyOf(entries, 2 * size + 4);
            for (int i = size; i < entries.length; i++) {
                entries[i] = new NearShape();
            }
        }
        entries[size++].set(shape, tangent, lowerBound);
    }

    /** Must be called when all shapes have been added. */
    void sort() {
        if (size > 1) {
            Arrays.sort(entries, 0, size, BY_LOWER_BOUND);
        }
    }

    /** Returns the distance to the nearest shape in a sector, metres, or positive infinity. */
    double nearest(SectorDistance sector) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < size && entries[i].lowerBound < least; i++) {
            NearShape entry = entries[i];
            least = Math.min(
                    least,
                    entry.mattSegment
                            ? sector.toSegment(entry.ax, entry.ay, entry.dx, entry.dy)
                            : nearest(sector, entry.shape, entry.tangent));
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
