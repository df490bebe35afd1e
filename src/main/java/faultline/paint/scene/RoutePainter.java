package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Shapes;
import faultline.world.WaypointPath;
import java.awt.Color;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * Paints the way-points of a moving obstacle: a broken line through dots with an arrow on each leg, and the speed
 * beside the longest.
 */
final class RoutePainter {

    private static final Stroke LINE_STROKE = DrawContext.dashedStroke(1.4, 7, 5);
    private static final Stroke ARROW_STROKE = DrawContext.solidStroke(1.8);
    private static final double DOT_RADIUS = 2.5;
    private static final double LABEL_GAP = 4;
    /** Where the speed stands, as a share of its leg: off the middle, where a name may be. */
    private static final double SPEED_POSITION = 0.35;

    private static final double ARROW_SIZE = 6;
    /** A leg shorter than this on the screen gets no arrow, pixels. */
    private static final double MIN_LEG_LENGTH = 24;

    private RoutePainter() {}

    static void paint(DrawContext brush, WaypointPath motion) {
        Color colour = brush.palette().movingOutline();
        List<Vector2> points = toScreen(brush.camera(), motion);
        // Back from the second point to the first the line is there already, and dashes laid over dashes would close
        // it.
        brush.draw(
                Shapes.polyline(motion.waypoints().size() == 2 ? points.subList(0, 2) : points), colour, LINE_STROKE);
        for (Vector2 point : points) {
            brush.fill(
                    new Ellipse2D.Double(
                            point.x() - DOT_RADIUS, point.y() - DOT_RADIUS, 2 * DOT_RADIUS, 2 * DOT_RADIUS),
                    colour);
        }
        for (int i = 1; i < points.size(); i++) {
            paintArrow(brush, points.get(i - 1), points.get(i), colour);
        }
        if (points.size() > 1) {
            paintSpeed(brush, motion.speed(), points);
        }
    }

    private static void paintSpeed(DrawContext brush, double speed, List<Vector2> points) {
        int longest = IntStream.range(1, points.size())
                .boxed()
                .max(Comparator.comparingDouble(i -> points.get(i).distanceTo(points.get(i - 1))))
                .orElseThrow();
        Vector2 leg = points.get(longest).minus(points.get(longest - 1));
        String text = String.format(Locale.ROOT, "%.2f m/s", speed);
        Rectangle2D box = brush.measureText(text);
        if (leg.length() < 2 * box.getWidth()) {
            return;
        }
        // On the left of the leg, off it by as much as keeps the text clear in any direction.
        Vector2 aside = new Vector2(leg.y(), -leg.x()).times(1 / leg.length());
        double clear = (Math.abs(aside.x()) * box.getWidth() + Math.abs(aside.y()) * box.getHeight()) / 2 + LABEL_GAP;
        Vector2 place = points.get(longest - 1).plus(leg.times(SPEED_POSITION)).plus(aside.times(clear));
        brush.drawLabel(text, place.x(), place.y(), brush.palette().text());
    }

    /** The way-points in the picture; those of a loop end where they began. */
    private static List<Vector2> toScreen(Camera camera, WaypointPath motion) {
        List<Vector2> points = new ArrayList<>(
                motion.waypoints().stream().map(camera::toScreen).toList());
        if (motion.loop()) {
            points.add(points.get(0));
        }
        return points;
    }

    private static void paintArrow(DrawContext brush, Vector2 from, Vector2 to, Color colour) {
        Vector2 leg = to.minus(from);
        if (leg.length() < MIN_LEG_LENGTH) {
            return;
        }
        Vector2 ahead = leg.times(ARROW_SIZE / leg.length());
        // Beyond the middle, so that the arrows of a leg that is walked both ways do not cover each other.
        Vector2 tip = from.plus(leg.times(0.6));
        Path2D arrow = Shapes.polyline(List.of(
                tip.minus(ahead).plus(ahead.perpendicular().times(0.7)),
                tip,
                tip.minus(ahead).minus(ahead.perpendicular().times(0.7))));
        brush.draw(arrow, colour, ARROW_STROKE);
    }
}
