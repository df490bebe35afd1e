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
 * Paints the contacts, a cross in a ring where the first collision was, and a badge that says where and when, and what
 * was broken then.
 */
final class CollisionPainter {

    /** The radius of the ring about the first collision, pixels. */
    static final double RING_RADIUS = 10;

    private static final double CONTACT_RADIUS = 7;
    private static final double CROSS_ARM = 4;
    private static final double BADGE_MARGIN = 5;
    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** From the middle of a line down to where its letters stand, pixels. */
    private static final double BASELINE_OFFSET = 4.5;

    private static final double DOT_RADIUS = 4.5;

    private CollisionPainter() {}

    static void paint(DrawContext brush, Snapshot world) {
        for (Vector2 contact : world.contacts()) {
            Vector2 place = brush.camera().toScreen(contact);
            brush.drawRing(
                    place.x(), place.y(), CONTACT_RADIUS, 2, brush.palette().contact());
        }
        world.collision().ifPresent(collision -> paintMark(brush, brush.camera().toScreen(collision.point())));
    }

    private static void paintMark(DrawContext brush, Vector2 at) {
        Color colour = brush.palette().contact();
        brush.drawRing(at.x(), at.y(), RING_RADIUS, 2.4, colour);
        brush.draw(
                new Line2D.Double(at.x() - CROSS_ARM, at.y() - CROSS_ARM, at.x() + CROSS_ARM, at.y() + CROSS_ARM),
                colour,
                DrawContext.solidStroke(2));
        brush.draw(
                new Line2D.Double(at.x() - CROSS_ARM, at.y() + CROSS_ARM, at.x() + CROSS_ARM, at.y() - CROSS_ARM),
                colour,
                DrawContext.solidStroke(2));
    }

    static void paintBadge(DrawContext brush, Collision collision, SceneLabels words) {
        List<String> lines = badgeLines(collision, words);
        double text = lines.stream()
                .mapToDouble(line -> brush.measureText(line).getWidth())
                .max()
                .orElseThrow();
        double height = brush.scaleToFont(LINE_HEIGHT);
        Rectangle2D frame = new Rectangle2D.Double(
                BADGE_MARGIN, BADGE_MARGIN, text + 3 * PADDING + 2 * DOT_RADIUS, height * lines.size() + PADDING);
        Shape badge = new RoundRectangle2D.Double(
                frame.getX() + 0.5, frame.getY() + 0.5, frame.getWidth(), frame.getHeight(), 8, 8);
        brush.fill(badge, brush.palette().canvas());
        brush.draw(badge, brush.palette().contact(), DrawContext.solidStroke(1.6));
        double middle = frame.getY() + 0.5 + (PADDING + height) / 2;
        brush.fill(
                new Ellipse2D.Double(frame.getX() + PADDING, middle - DOT_RADIUS, 2 * DOT_RADIUS, 2 * DOT_RADIUS),
                brush.palette().contact());
        for (int i = 0; i < lines.size(); i++) {
            brush.drawText(
                    lines.get(i),
                    frame.getX() + 2 * PADDING + 2 * DOT_RADIUS,
                    middle + brush.scaleToFont(BASELINE_OFFSET) + i * height,
                    brush.palette().text());
        }
    }

    /** What the badge says, a line each. */
    static List<String> badgeLines(Collision collision, SceneLabels words) {
        List<String> lines = new ArrayList<>();
        lines.add(words.collision()
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
                    .forEach((sensor, faults) -> faults.forEach(
                            fault -> broken.add(sensor + " " + words.faultName().apply(fault.kind()))));
            lines.add(words.faults() + ": " + String.join(", ", broken));
        }
        if (!collision.switchedOff().isEmpty()) {
            lines.add(words.sensorsOff() + ": " + String.join(", ", collision.switchedOff()));
        }
        return lines;
    }
}
