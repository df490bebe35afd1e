package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Shapes;
import faultline.world.WaypointPath;
import java.awt.Color;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * Paints the route of a moving obstacle: a dashed line through dots at its waypoints with an arrow on each leg, and the
 * speed beside the longest leg. Hundreds of legs in the picture are thin lines without dashes, dots and arrows, which
 * take little time.
 */
final class RoutePainter {

    private static final Stroke LINE_STROKE = DrawContext.dashedStroke(1.4, 7, 5);
    private static final Stroke ARROW_STROKE = DrawContext.solidStroke(1.8);
    private static final double DOT_RADIUS = 2.5;
    private static final double LABEL_GAP = 4;
    /** The positions of the speed, as fractions of its leg, the best one first; a name may be in the middle. */
    private static final double[] SPEED_POSITIONS = {0.35, 0.65, 0.2, 0.8};

    private static final double ARROW_SIZE = 6;
    /** The minimum length of a leg with an arrow, pixels. */
    private static final double MIN_LEG_LENGTH = 24;

    private RoutePainter() {}

    /** Paints a route, whose speed does not cover other labels if there is room, given their bounding boxes, pixels. */
    static void paint(DrawContext context, WaypointPath motion, List<Rectangle2D> taken) {
        List<Vector2> points = toScreen(context.camera(), motion);
        List<List<Vector2>> pieces =
                VisibleRoute.pieces(points, context.camera().bounds());
        if (VisibleRoute.isCrowded(pieces)) {
            paintThin(context, pieces);
        } else {
            // Between two points the way back would fill the gaps between the dashes.
            boolean oneWay = motion.waypoints().size() == 2;
            pieces.forEach(piece -> paintPiece(context, piece, oneWay ? piece.subList(0, 2) : piece));
        }
        if (points.size() > 1) {
            paintSpeed(context, motion.speed(), points, taken);
        }
    }

    private static void paintThin(DrawContext context, List<List<Vector2>> pieces) {
        Path2D lines = new Path2D.Double();
        pieces.forEach(piece -> lines.append(Shapes.polyline(piece), false));
        context.drawThin(lines, context.palette().movingOutline());
    }

    private static void paintPiece(DrawContext context, List<Vector2> points, List<Vector2> line) {
        Color colour = context.palette().movingOutline();
        context.draw(Shapes.polyline(line), colour, LINE_STROKE);
        for (Vector2 point : points) {
            context.fill(Shapes.circle(point, DOT_RADIUS), colour);
        }
        for (int i = 1; i < points.size(); i++) {
            paintArrow(context, points.get(i - 1), points.get(i), colour);
        }
    }

    private static void paintSpeed(DrawContext context, double speed, List<Vector2> points, List<Rectangle2D> taken) {
        int longest = IntStream.range(1, points.size())
                .boxed()
                .max(Comparator.comparingDouble(i -> points.get(i).distanceTo(points.get(i - 1))))
                .orElseThrow();
        Vector2 leg = points.get(longest).minus(points.get(longest - 1));
        String text = String.format(Locale.ROOT, "%.2f m/s", speed);
        Rectangle2D size = context.measureText(text);
        if (leg.length() >= 2 * size.getWidth()) {
            Vector2 place = speedPlace(points.get(longest - 1), leg, size, taken);
            context.drawLabel(text, place.x(), place.y(), context.palette().text());
        }
    }

    /**
     * Returns the centre of the speed beside a leg from a point: the first free place of all, or simply the first. The
     * text is to the left of the leg, or else to the right, at a distance at which it does not touch a leg of any
     * direction.
     */
    private static Vector2 speedPlace(Vector2 from, Vector2 leg, Rectangle2D size, List<Rectangle2D> taken) {
        Vector2 aside = new Vector2(leg.y(), -leg.x()).times(1 / leg.length());
        double clear = (Math.abs(aside.x()) * size.getWidth() + Math.abs(aside.y()) * size.getHeight()) / 2 + LABEL_GAP;
        List<Vector2> places = new ArrayList<>();
        for (double position : SPEED_POSITIONS) {
            Vector2 onLeg = from.plus(leg.times(position));
            places.add(onLeg.plus(aside.times(clear)));
            places.add(onLeg.minus(aside.times(clear)));
        }
        return places.stream()
                .filter(place -> taken.stream()
                        .noneMatch(box -> box.intersects(
                                place.x() - size.getWidth() / 2,
                                place.y() - size.getHeight() / 2,
                                size.getWidth(),
                                size.getHeight())))
                .findFirst()
                .orElse(places.get(0));
    }

    /** Returns the waypoints in the picture; those of a loop end at the first. */
    private static List<Vector2> toScreen(Camera camera, WaypointPath motion) {
        List<Vector2> points = new ArrayList<>(
                motion.waypoints().stream().map(camera::toScreen).toList());
        if (motion.loop()) {
            points.add(points.get(0));
        }
        return points;
    }

    private static void paintArrow(DrawContext context, Vector2 from, Vector2 to, Color colour) {
        Vector2 leg = to.minus(from);
        if (leg.length() < MIN_LEG_LENGTH) {
            return;
        }
        Vector2 ahead = leg.times(ARROW_SIZE / leg.length());
        // The tip is beyond the middle, so that the arrows of a leg that is driven in both directions do not overlap.
        Vector2 tip = from.plus(leg.times(0.6));
        Path2D arrow = Shapes.polyline(List.of(
                tip.minus(ahead).plus(ahead.perpendicular().times(0.7)),
                tip,
                tip.minus(ahead).minus(ahead.perpendicular().times(0.7))));
        context.draw(arrow, colour, ARROW_STROKE);
    }
}
