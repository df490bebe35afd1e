package faultline.paint;

import faultline.geometry.Vec;
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

/** Paints the contacts, a cross in a ring where the first collision was, and a badge that says where and when, and what was broken then. */
final class CollisionPainter {

    /** The radius of the ring about the first collision, pixels. */
    static final double RADIUS = 10;

    private static final double CONTACT_RADIUS = 7;
    private static final double ARM = 4;
    private static final double BADGE_AT = 5;
    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** From the middle of a line down to where its letters stand, pixels. */
    private static final double BASE = 4.5;
    private static final double DOT = 4.5;

    private CollisionPainter() {
    }

    static void paint(Brush brush, Snapshot world) {
        for (Vec contact : world.contacts()) {
            Vec place = brush.camera().toScreen(contact);
            brush.ring(place.x(), place.y(), CONTACT_RADIUS, 2, brush.palette().hit());
        }
        world.collision().ifPresent(collision -> mark(brush, brush.camera().toScreen(collision.point())));
    }

    private static void mark(Brush brush, Vec at) {
        Color colour = brush.palette().hit();
        brush.ring(at.x(), at.y(), RADIUS, 2.4, colour);
        brush.draw(new Line2D.Double(at.x() - ARM, at.y() - ARM, at.x() + ARM, at.y() + ARM), colour, Brush.solid(2));
        brush.draw(new Line2D.Double(at.x() - ARM, at.y() + ARM, at.x() + ARM, at.y() - ARM), colour, Brush.solid(2));
    }

    static void paintBadge(Brush brush, Collision collision, Words words) {
        List<String> lines = lines(collision, words);
        double text = lines.stream().mapToDouble(line -> brush.measure(line).getWidth()).max().orElseThrow();
        double height = brush.enlarged(LINE_HEIGHT);
        Rectangle2D frame = new Rectangle2D.Double(BADGE_AT, BADGE_AT, text + 3 * PADDING + 2 * DOT, height * lines.size() + PADDING);
        Shape badge = new RoundRectangle2D.Double(frame.getX() + 0.5, frame.getY() + 0.5, frame.getWidth(), frame.getHeight(), 8, 8);
        brush.fill(badge, brush.palette().canvas());
        brush.draw(badge, brush.palette().hit(), Brush.solid(1.6));
        double middle = frame.getY() + 0.5 + (PADDING + height) / 2;
        brush.fill(new Ellipse2D.Double(frame.getX() + PADDING, middle - DOT, 2 * DOT, 2 * DOT), brush.palette().hit());
        for (int i = 0; i < lines.size(); i++) {
            brush.text(lines.get(i), frame.getX() + 2 * PADDING + 2 * DOT, middle + brush.enlarged(BASE) + i * height, brush.palette().text());
        }
    }

    /** What the badge says, a line each. */
    static List<String> lines(Collision collision, Words words) {
        List<String> lines = new ArrayList<>();
        lines.add(words.collision() + String.format(Locale.ROOT, "   x %.3f m   y %.3f m   t %.3f s   %s",
                collision.point().x(), collision.point().y(), collision.time(), collision.obstacle()));
        if (!collision.faults().isEmpty()) {
            List<String> broken = new ArrayList<>();
            collision.faults().forEach((sensor, faults) -> faults.forEach(fault -> broken.add(sensor + " " + words.fault().apply(fault.kind()))));
            lines.add(words.faults() + ": " + String.join(", ", broken));
        }
        if (!collision.off().isEmpty()) {
            lines.add(words.off() + ": " + String.join(", ", collision.off()));
        }
        return lines;
    }
}
