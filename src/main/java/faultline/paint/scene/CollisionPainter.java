package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Paints rings at contacts, a cross in a ring at the first collision, and a badge with its position, its time and the
 * faults at that time.
 */
final class CollisionPainter {

    /** The radius of the ring around the first collision, pixels. */
    static final double RING_RADIUS = 10;

    private static final double CONTACT_RADIUS = 7;
    private static final double CROSS_ARM = 4;
    private static final double BADGE_MARGIN = 5;
    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** From the middle of a line of text down to its baseline, pixels. */
    private static final double BASELINE_OFFSET = 4.5;

    private static final double DOT_RADIUS = 4.5;

    private CollisionPainter() {}

    static void paint(DrawContext context, Snapshot world) {
        for (Vector2 contact : world.contacts()) {
            Vector2 place = context.camera().toScreen(contact);
            context.drawRing(
                    place.x(), place.y(), CONTACT_RADIUS, 2, context.palette().collision());
        }
        world.collision()
                .ifPresent(collision -> paintMark(context, context.camera().toScreen(collision.point())));
    }

    private static void paintMark(DrawContext context, Vector2 at) {
        Color colour = context.palette().collision();
        context.drawRing(at.x(), at.y(), RING_RADIUS, 2.4, colour);
        context.draw(
                new Line2D.Double(at.x() - CROSS_ARM, at.y() - CROSS_ARM, at.x() + CROSS_ARM, at.y() + CROSS_ARM),
                colour,
                DrawContext.solidStroke(2));
        context.draw(
                new Line2D.Double(at.x() - CROSS_ARM, at.y() + CROSS_ARM, at.x() + CROSS_ARM, at.y() - CROSS_ARM),
                colour,
                DrawContext.solidStroke(2));
    }

    static void paintBadge(DrawContext context, Collision collision, SceneLabels labels) {
        List<String> lines = badgeLines(collision, labels);
        double text = lines.stream()
                .mapToDouble(line -> context.measureText(line).getWidth())
                .max()
                .orElseThrow();
        double height = context.scaleToFont(LINE_HEIGHT);
        Rectangle2D frame = new Rectangle2D.Double(
                BADGE_MARGIN, BADGE_MARGIN, text + 3 * PADDING + 2 * DOT_RADIUS, height * lines.size() + PADDING);
        Shape badge = new RoundRectangle2D.Double(
                frame.getX() + 0.5, frame.getY() + 0.5, frame.getWidth(), frame.getHeight(), 8, 8);
        context.fill(badge, context.palette().canvas());
        context.draw(badge, context.palette().collision(), DrawContext.solidStroke(1.6));
        double middle = frame.getY() + 0.5 + (PADDING + height) / 2;
        context.fill(
                new Ellipse2D.Double(frame.getX() + PADDING, middle - DOT_RADIUS, 2 * DOT_RADIUS, 2 * DOT_RADIUS),
                context.palette().collision());
        for (int i = 0; i < lines.size(); i++) {
            context.drawText(
                    lines.get(i),
                    frame.getX() + 2 * PADDING + 2 * DOT_RADIUS,
                    middle + context.scaleToFont(BASELINE_OFFSET) + i * height,
                    context.palette().text());
        }
    }

    /** Returns the lines of the badge. */
    static List<String> badgeLines(Collision collision, SceneLabels labels) {
        List<String> lines = new ArrayList<>();
        lines.add(labels.collision()
                + String.format(
                        Locale.ROOT,
                        "   x %.3f m   y %.3f m   t %.3f s   %s",
                        collision.point().x(),
                        collision.point().y(),
                        collision.time(),
                        collision.obstacle()));
        if (!collision.faults().isEmpty()) {
            List<String> broken = new ArrayList<>();
            collision
                    .faults()
                    .forEach((sensor, faults) -> faults.forEach(fault ->
                            broken.add(sensor + " " + labels.faultName().apply(fault.kind()))));
            lines.add(labels.faults() + ": " + String.join(", ", broken));
        }
        if (!collision.switchedOff().isEmpty()) {
            lines.add(labels.sensorsOff() + ": " + String.join(", ", collision.switchedOff()));
        }
        return lines;
    }
}
