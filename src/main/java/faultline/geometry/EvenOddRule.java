package faultline.geometry;

import java.util.List;

/** The even-odd rule: a point is inside if a ray from it to the right crosses an odd number of sides. */
public final class EvenOddRule {

    private EvenOddRule() {}

    /**
     * {@return whether a point is inside a ring}
     *
     * @param ring the corners in either order; the last one is joined to the first one
     * @param point the point
     */
    public static boolean isInside(List<Vector2> ring, Vector2 point) {
        boolean inside = false;
        Vector2 from = ring.get(ring.size() - 1);
        for (int i = 0; i < ring.size(); i++) {
            Vector2 to = ring.get(i);
            inside ^= crosses(point.x(), point.y(), from.x(), from.y(), to.x(), to.y());
            from = to;
        }
        return inside;
    }

    /**
     * {@return whether the ray to the right from a point crosses a side} The lower end of a side belongs to it, the
     * upper one does not.
     *
     * @param x the point, metres
     * @param y the point, metres
     * @param fromX the start of the side, metres
     * @param fromY the start of the side, metres
     * @param toX the end of the side, metres
     * @param toY the end of the side, metres
     */
    public static boolean crosses(double x, double y, double fromX, double fromY, double toX, double toY) {
        return fromY > y != toY > y && x < fromX + (y - fromY) / (toY - fromY) * (toX - fromX);
    }
}
