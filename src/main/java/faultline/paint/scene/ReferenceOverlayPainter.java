package faultline.paint.scene;

import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.robot.RobotSpec;
import faultline.world.Snapshot;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;

/** Paints a reference run: its path, its robot as a dashed outline, a mark at the first difference, and a caption. */
public final class ReferenceOverlayPainter {

    private static final Stroke DASHED_STROKE = DrawContext.dashedStroke(1.6, 4, 3);
    private static final Stroke SOLID_STROKE = DrawContext.solidStroke(1.8);
    private static final double MARK_RADIUS = 8;
    private static final double MARGIN = 8;
    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** From the middle of a line of text down to its baseline, pixels. */
    private static final double BASELINE_OFFSET = 4.5;

    private static final double SAMPLE_LENGTH = 26;

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
        RobotSpec robot = world.robot();
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

    /** Paints the marks and the caption. */
    public static void paintAnnotations(DrawContext context, ReferenceOverlay reference) {
        for (ReferenceOverlay.Mark mark : reference.marks()) {
            paintMark(
                    context,
                    mark.label(),
                    context.camera().toScreen(reference.run().pose(mark.tick()).position()));
        }
        paintCaption(context, reference);
    }

    private static Shape arrow(RobotSpec robot) {
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(0, robot.width() * 0.25);
        arrow.lineTo(robot.length() * 0.3, 0);
        arrow.lineTo(0, -robot.width() * 0.25);
        return arrow;
    }

    /** Paints a diamond with a line across. */
    private static void paintMark(DrawContext context, String text, Vector2 at) {
        Color colour = context.palette().reference();
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(at.x() - MARK_RADIUS, at.y());
        diamond.lineTo(at.x(), at.y() - MARK_RADIUS);
        diamond.lineTo(at.x() + MARK_RADIUS, at.y());
        diamond.lineTo(at.x(), at.y() + MARK_RADIUS);
        diamond.closePath();
        context.draw(diamond, context.palette().canvas(), DrawContext.HALO_STROKE);
        context.draw(diamond, colour, SOLID_STROKE);
        context.draw(
                new Line2D.Double(
                        at.x() - MARK_RADIUS / 2,
                        at.y() + MARK_RADIUS / 2,
                        at.x() + MARK_RADIUS / 2,
                        at.y() - MARK_RADIUS / 2),
                colour,
                SOLID_STROKE);
        context.drawLabel(text, at.x(), at.y() - MARK_RADIUS - context.scaleToFont(LINE_HEIGHT) / 2, colour);
    }

    /** Paints the caption in the lower left corner, with a sample of the robot's outline. */
    private static void paintCaption(DrawContext context, ReferenceOverlay reference) {
        double text = reference.caption().stream()
                .mapToDouble(words -> context.measureText(words).getWidth())
                .max()
                .orElse(0);
        double line = context.scaleToFont(LINE_HEIGHT);
        double height = line * reference.caption().size() + PADDING;
        double top = Math.rint(context.camera().height() - MARGIN - height) + 0.5;
        Shape badge = new RoundRectangle2D.Double(
                MARGIN + 0.5, top, Math.ceil(text + SAMPLE_LENGTH + 3 * PADDING), height, 8, 8);
        context.fill(badge, context.palette().canvas());
        context.draw(badge, context.palette().reference(), DrawContext.solidStroke(1));
        double middle = top + (PADDING + line) / 2;
        context.draw(
                new Line2D.Double(MARGIN + PADDING, middle, MARGIN + PADDING + SAMPLE_LENGTH, middle),
                context.palette().reference(),
                DASHED_STROKE);
        for (int i = 0; i < reference.caption().size(); i++) {
            context.drawText(
                    reference.caption().get(i),
                    MARGIN + 2 * PADDING + SAMPLE_LENGTH,
                    middle + context.scaleToFont(BASELINE_OFFSET) + i * line,
                    context.palette().text());
        }
    }
}
