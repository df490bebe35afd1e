package faultline.paint.scene;

import faultline.geometry.Vector2;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;

/**
 * Leaves out what cannot be seen of a long route, which is painted in every frame. A route of at most {@link #MANY}
 * points is not changed. All coordinates are in pixels.
 */
final class VisibleRoute {

    /** Routes of more points than this are painted more simply. */
    static final int MANY = 500;

    /** Points nearer than this to the last one are omitted, pixels. */
    private static final double THINNING = 0.7;
    /** The greatest reach of a dot, an arrow or a handle beyond its leg or point, pixels. */
    private static final int REACH = 8;

    private VisibleRoute() {}

    /** Returns the pieces of a route whose legs all cross the picture. */
    static List<List<Vector2>> pieces(List<Vector2> route, Rectangle picture) {
        if (route.size() <= MANY) {
            return List.of(route);
        }
        Rectangle near = withReach(picture);
        List<List<Vector2>> pieces = new ArrayList<>();
        List<Vector2> piece = new ArrayList<>();
        List<Vector2> points = thinned(route);
        for (int i = 1; i < points.size(); i++) {
            Vector2 from = points.get(i - 1);
            Vector2 to = points.get(i);
            if (!near.intersectsLine(from.x(), from.y(), to.x(), to.y())) {
                piece = new ArrayList<>();
                continue;
            }
            if (piece.isEmpty()) {
                piece.add(from);
                pieces.add(piece);
            }
            piece.add(to);
        }
        return pieces;
    }

    /** Returns whether pieces of a route have so many legs that they are painted more simply. */
    static boolean isCrowded(List<List<Vector2>> pieces) {
        return pieces.stream().mapToInt(piece -> piece.size() - 1).sum() >= MANY;
    }

    /** Returns the waypoints of which something may be seen in the picture. */
    static List<Vector2> waypoints(List<Vector2> waypoints, Rectangle picture) {
        if (waypoints.size() <= MANY) {
            return waypoints;
        }
        Rectangle near = withReach(picture);
        return thinned(waypoints).stream()
                .filter(point -> near.contains(point.x(), point.y()))
                .toList();
    }

    private static Rectangle withReach(Rectangle picture) {
        Rectangle near = new Rectangle(picture);
        near.grow(REACH, REACH);
        return near;
    }

    /** Returns the points without those that almost coincide with the one before; the last is kept. */
    private static List<Vector2> thinned(List<Vector2> points) {
        List<Vector2> kept = new ArrayList<>();
        Vector2 last = points.get(0);
        kept.add(last);
        for (Vector2 point : points.subList(1, points.size() - 1)) {
            if (point.distanceTo(last) >= THINNING) {
                kept.add(point);
                last = point;
            }
        }
        kept.add(points.get(points.size() - 1));
        return kept;
    }
}
