package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Shapes;
import faultline.robot.MotorSide;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Paints rings at contacts, a cross in a ring at the first collision, and a badge with its position, its time and the
 * faults at that time.
 */
final class CollisionPainter {

    /** The radius of the ring around the first collision, pixels. */
    static final double RING_RADIUS = 10;

    private static final double CONTACT_RADIUS = 7;
    private static final double CROSS_ARM = 4;
    /** The distance of the badge from the edges of the picture and from what covers it, pixels. */
    private static final double BADGE_MARGIN = 5;

    private static final double DOT_RADIUS = 4.5;

    private CollisionPainter() {}

    static void paint(DrawContext context, Snapshot world) {
        for (Vector2 contact : world.contacts()) {
            context.drawRing(
                    context.camera().toScreen(contact),
                    CONTACT_RADIUS,
                    2,
                    context.palette().collision());
        }
        world.collision()
                .ifPresent(collision -> paintMark(context, context.camera().toScreen(collision.point())));
    }

    private static void paintMark(DrawContext context, Vector2 at) {
        Color colour = context.palette().collision();
        context.drawRing(at, RING_RADIUS, 2.4, colour);
        context.drawCross(Shapes.circle(at, CROSS_ARM).getBounds2D(), colour);
    }

    /**
     * Paints the badge in an upper corner, below the areas there that will be covered, pixels: in the left one, unless
     * only there it would hide the robot.
     */
    static void paintBadge(DrawContext context, Snapshot world, SceneLabels labels, List<Rectangle2D> covered) {
        Color colour = context.palette().collision();
        List<String> lines = BadgePainter.shortened(
                context,
                badgeLines(world.collision().orElseThrow(), labels),
                2 * DOT_RADIUS,
                context.camera().width() - 2 * BADGE_MARGIN);
        double width = BadgePainter.width(context, lines, 2 * DOT_RADIUS);
        double height = BadgePainter.height(context, lines.size());
        Rectangle2D robot = CornerChoice.robotArea(context.camera(), world.robot(), world.pose());
        Rectangle2D left = belowOf(new Rectangle2D.Double(BADGE_MARGIN, BADGE_MARGIN, width, height), covered);
        Rectangle2D right = belowOf(
                new Rectangle2D.Double(
                        Math.floor(context.camera().width() - BADGE_MARGIN - width), BADGE_MARGIN, width, height),
                covered);
        Rectangle2D badge = left.intersects(robot) && !right.intersects(robot) ? right : left;
        Vector2 dot = BadgePainter.paint(
                context, new Vector2(badge.getX(), badge.getY()), lines, 2 * DOT_RADIUS, colour, 1.6);
        context.fill(Shapes.circle(dot.plus(new Vector2(DOT_RADIUS, 0)), DOT_RADIUS), colour);
    }

    private static Rectangle2D belowOf(Rectangle2D badge, List<Rectangle2D> covered) {
        Rectangle2D.Double moved =
                new Rectangle2D.Double(badge.getX(), badge.getY(), badge.getWidth(), badge.getHeight());
        // In this order, a badge does not come to lie over an area that it has passed.
        covered.stream()
                .sorted(Comparator.comparingDouble(Rectangle2D::getMaxY))
                .filter(moved::intersects)
                .forEachOrdered(area -> moved.y = area.getMaxY() + BADGE_MARGIN);
        return moved;
    }

    static List<String> badgeLines(Collision collision, SceneLabels labels) {
        List<String> lines = new ArrayList<>();
        lines.add(labels.collision()
                + "   x " + DecimalText.formatFixed(collision.point().x(), 3)
                + " m   y " + DecimalText.formatFixed(collision.point().y(), 3)
                + " m   t " + DecimalText.formatFixed(collision.time(), 3)
                + " s   " + collision.obstacle());
        List<String> broken = new ArrayList<>();
        collision
                .faults()
                .forEach((sensor, faults) -> faults.forEach(
                        fault -> broken.add(sensor + " " + labels.faultName().apply(fault.kind()))));
        for (MotorSide side : MotorSide.values()) {
            collision
                    .motorFaults()
                    .of(side)
                    .forEach(fault -> broken.add(labels.motors().apply(side) + " "
                            + labels.faultName().apply(fault.kind())));
        }
        if (!broken.isEmpty()) {
            lines.add(labels.faults() + ": " + String.join(", ", broken));
        }
        if (!collision.switchedOff().isEmpty()) {
            lines.add(labels.sensorsOff() + ": " + String.join(", ", collision.switchedOff()));
        }
        return lines;
    }
}
