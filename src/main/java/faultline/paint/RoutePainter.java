package faultline.paint;

import faultline.geometry.Vec;
import faultline.world.Motion;
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

/** Paints the way-points of a moving obstacle: a broken line through dots with an arrow on each leg, and the speed beside the longest. */
final class RoutePainter {

    private static final Stroke LINE = Brush.dashed(1.4, 7, 5);
    private static final Stroke ARROW = Brush.solid(1.8);
    private static final double DOT = 2.5;
    private static final double GAP = 4;
    /** Where the speed stands, as a share of its leg: off the middle, where a name may be. */
    private static final double SPEED_AT = 0.35;
    private static final double ARROW_SIZE = 6;
    /** A leg shorter than this on the screen gets no arrow, pixels. */
    private static final double LEAST_LEG = 24;

    private RoutePainter() {
    }

    static void paint(Brush brush, Motion motion) {
        Color colour = brush.palette().movingOutline();
        List<Vec> points = onScreen(brush.camera(), motion);
        // Back from the second point to the first the line is there already, and dashes laid over dashes would close it.
        brush.draw(ObstacleOutlines.through(motion.points().size() == 2 ? points.subList(0, 2) : points), colour, LINE);
        for (Vec point : points) {
            brush.fill(new Ellipse2D.Double(point.x() - DOT, point.y() - DOT, 2 * DOT, 2 * DOT), colour);
        }
        for (int i = 1; i < points.size(); i++) {
            arrow(brush, points.get(i - 1), points.get(i), colour);
        }
        if (points.size() > 1) {
            speed(brush, motion.speed(), points);
        }
    }

    private static void speed(Brush brush, double speed, List<Vec> points) {
        int longest = IntStream.range(1, points.size()).boxed()
                .max(Comparator.comparingDouble(i -> points.get(i).distanceTo(points.get(i - 1)))).orElseThrow();
        Vec leg = points.get(longest).minus(points.get(longest - 1));
        String text = String.format(Locale.ROOT, "%.2f m/s", speed);
        Rectangle2D box = brush.measure(text);
        if (leg.length() < 2 * box.getWidth()) {
            return;
        }
        // On the left of the leg, off it by as much as keeps the text clear in any direction.
        Vec aside = new Vec(leg.y(), -leg.x()).times(1 / leg.length());
        double clear = (Math.abs(aside.x()) * box.getWidth() + Math.abs(aside.y()) * box.getHeight()) / 2 + GAP;
        Vec place = points.get(longest - 1).plus(leg.times(SPEED_AT)).plus(aside.times(clear));
        brush.label(text, place.x(), place.y(), brush.palette().text());
    }

    /** The way-points in the picture; those of a loop end where they began. */
    private static List<Vec> onScreen(Camera camera, Motion motion) {
        List<Vec> points = new ArrayList<>(motion.points().stream().map(camera::toScreen).toList());
        if (motion.loop()) {
            points.add(points.get(0));
        }
        return points;
    }

    private static void arrow(Brush brush, Vec from, Vec to, Color colour) {
        Vec leg = to.minus(from);
        if (leg.length() < LEAST_LEG) {
            return;
        }
        Vec ahead = leg.times(ARROW_SIZE / leg.length());
        // Beyond the middle, so that the arrows of a leg that is walked both ways do not cover each other.
        Vec tip = from.plus(leg.times(0.6));
        Path2D arrow = ObstacleOutlines.through(List.of(tip.minus(ahead).plus(ahead.perpendicular().times(0.7)), tip,
                tip.minus(ahead).minus(ahead.perpendicular().times(0.7))));
        brush.draw(arrow, colour, ARROW);
    }
}
