package faultline.paint.scene;

import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Shapes;
import faultline.robot.RobotSpec;
import faultline.world.Snapshot;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Paints a reference run: its path, its robot as a dashed outline, marks at its first collision and at the first
 * difference, and a caption.
 */
public final class ReferenceOverlayPainter {

    /** The least distance of the label of a mark from the sides of the picture, pixels. */
    private static final double LABEL_MARGIN = 2;

    private static final Stroke DASHED_STROKE = DrawContext.dashedStroke(1.6, 4, 3);
    private static final Stroke SOLID_STROKE = DrawContext.solidStroke(1.8);
    private static final double MARK_RADIUS = 8;
    private static final double COLLISION_RADIUS = 11;
    private static final double MARGIN = 8;
    /** The distance from a mark up to the middle of its label, pixels. */
    private static final double LABEL_GAP = 8.5;

    /** The minimum height of the description of a collision, pixels. */
    private static final double BADGE_HEIGHT = 20;

    private static final double SAMPLE_LENGTH = 26;
    /** The distance from the caption down to the scale bar, pixels. */
    private static final double SCALE_BAR_GAP = 3;

    private ReferenceOverlayPainter() {}

    /** Paints the whole path. */
    static void paintPath(DrawContext context, ReferenceOverlay reference) {
        PathPainter.paint(
                context,
                reference.run().path(),
                PathStyle.REFERENCE,
                0,
                Integer.MAX_VALUE,
                context.camera().bounds());
    }

    /** Paints the robot of the reference run at the time of a world. */
    public static void paintRobot(DrawContext context, ReferenceOverlay reference, Snapshot world) {
        RobotSpec robot = reference.robotAt(world.time());
        AffineTransform frame = RigidMotion.poseTransform(reference.poseAt(world.time()));
        Color colour = context.palette().reference();
        context.draw(
                context.toScreen(
                        new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width()),
                        frame),
                colour,
                DASHED_STROKE);
        context.draw(context.toScreen(arrow(robot), frame), colour, SOLID_STROKE);
    }

    /** Returns a new choice of the corner of a caption. The robot's collision is described in the upper left one. */
    public static CornerChoice createCornerChoice() {
        return new CornerChoice(
                CornerChoice.Corner.LOWER_LEFT, CornerChoice.Corner.UPPER_RIGHT, CornerChoice.Corner.LOWER_RIGHT);
    }

    /**
     * Paints the collision, the marks, and the caption in a corner that hides neither robot nor the covered areas,
     * pixels, nor the cones if there is one that is free of them.
     */
    public static void paintAnnotations(
            DrawContext context,
            ReferenceOverlay reference,
            Snapshot world,
            CornerChoice corner,
            List<Rectangle2D> covered) {
        reference
                .run()
                .collision()
                .ifPresent(collision -> paintCollision(context, context.camera().toScreen(collision.point())));
        for (ReferenceOverlay.Mark mark : reference.marks()) {
            paintMark(
                    context,
                    mark.label(),
                    context.camera().toScreen(reference.run().pose(mark.tick()).position()));
        }
        List<Rectangle2D> avoided = new ArrayList<>(covered);
        avoided.add(CornerChoice.robotArea(context.camera(), world.robot(), world.pose()));
        avoided.add(CornerChoice.robotArea(
                context.camera(), reference.robotAt(world.time()), reference.poseAt(world.time())));
        world.collision()
                .ifPresent(collision -> avoided.add(new Rectangle2D.Double(
                        0, 0, context.camera().width(), BADGE_HEIGHT + context.scaleToFont(BADGE_HEIGHT))));
        List<Rectangle2D> cones = world.sensors().stream()
                .map(sensor -> ScreenSector.of(context.camera(), sensor.sector())
                        .outline()
                        .getBounds2D())
                .toList();
        paintCaption(context, reference, size -> corner.place(captionArea(context), size, avoided, cones));
    }

    private static Rectangle2D captionArea(DrawContext context) {
        Rectangle2D picture = context.camera().bounds();
        return new Rectangle2D.Double(
                MARGIN, MARGIN, picture.getWidth() - 2 * MARGIN, picture.getHeight() - 2 * MARGIN);
    }

    private static Shape arrow(RobotSpec robot) {
        return Shapes.polyline(List.of(
                new Vector2(0, robot.width() * 0.25),
                new Vector2(robot.length() * 0.3, 0),
                new Vector2(0, -robot.width() * 0.25)));
    }

    /** Paints a cross in a dashed ring. */
    private static void paintCollision(DrawContext context, Vector2 at) {
        Color colour = context.palette().reference();
        Shape ring = Shapes.circle(at, COLLISION_RADIUS);
        context.draw(ring, context.palette().canvas(), DrawContext.HALO_STROKE);
        context.draw(ring, colour, DASHED_STROKE);
        context.drawCross(Shapes.circle(at, MARK_RADIUS / 2).getBounds2D(), colour);
    }

    /** Paints a diamond with a line across. */
    private static void paintMark(DrawContext context, String text, Vector2 at) {
        Color colour = context.palette().reference();
        Vector2 right = new Vector2(MARK_RADIUS, 0);
        Vector2 down = new Vector2(0, MARK_RADIUS);
        Vector2 half = new Vector2(MARK_RADIUS / 2, -MARK_RADIUS / 2);
        Shape diamond = Shapes.polygon(List.of(at.minus(right), at.minus(down), at.plus(right), at.plus(down)));
        context.draw(diamond, context.palette().canvas(), DrawContext.HALO_STROKE);
        context.draw(diamond, colour, SOLID_STROKE);
        context.draw(Shapes.polyline(List.of(at.minus(half), at.plus(half))), colour, SOLID_STROKE);
        double x = context.camera().bounds().contains(at.x(), at.y()) ? labelX(context, text, at.x()) : at.x();
        context.drawLabel(text, x, at.y() - MARK_RADIUS - context.scaleToFont(LABEL_GAP), colour);
    }

    /** Returns the centre of a label at a mark, moved into the picture if necessary. */
    private static double labelX(DrawContext context, String text, double x) {
        double half = context.measureText(text).getWidth() / 2 + LABEL_MARGIN;
        return Math.max(half, Math.min(context.camera().width() - half, x));
    }

    /**
     * Returns a caption that fits in the picture. Its first line, which may end with a long name, is not wider than
     * half of it or the other lines.
     */
    private static List<String> shortenedCaption(DrawContext context, List<String> caption) {
        double width = captionArea(context).getWidth();
        List<String> others = BadgePainter.shortened(context, caption.subList(1, caption.size()), SAMPLE_LENGTH, width);
        double nameWidth = Math.max(width / 2, BadgePainter.width(context, others, SAMPLE_LENGTH));
        List<String> lines =
                new ArrayList<>(BadgePainter.shortened(context, caption.subList(0, 1), SAMPLE_LENGTH, nameWidth));
        lines.addAll(others);
        return lines;
    }

    /** Paints the caption with a sample of the robot's outline, given what places a box of its size. */
    private static void paintCaption(
            DrawContext context, ReferenceOverlay reference, UnaryOperator<Rectangle2D> placement) {
        Color colour = context.palette().reference();
        List<String> caption = shortenedCaption(context, reference.caption());
        Rectangle2D size = new Rectangle2D.Double(
                0,
                0,
                BadgePainter.width(context, caption, SAMPLE_LENGTH),
                BadgePainter.height(context, caption.size()));
        Rectangle2D place = placement.apply(size);
        Rectangle2D scaleBar = ScaleBarPainter.area(context);
        double top = place.intersects(scaleBar) ? scaleBar.getY() - size.getHeight() - SCALE_BAR_GAP : place.getY();
        Vector2 start = BadgePainter.paint(
                context, new Vector2(Math.rint(place.getX()), Math.rint(top)), caption, SAMPLE_LENGTH, colour, 1);
        Shape sample = Shapes.polyline(List.of(start, start.plus(new Vector2(SAMPLE_LENGTH, 0))));
        context.draw(sample, colour, DASHED_STROKE);
    }
}
