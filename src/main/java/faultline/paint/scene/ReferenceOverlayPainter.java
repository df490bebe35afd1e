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

/**
 * Paints an earlier run beside the one that shows: its robot as a dashed outline, a mark where the two first differ,
 * and a caption.
 */
public final class ReferenceOverlayPainter {

    private static final Stroke DASHED_STROKE = DrawContext.dashedStroke(1.6, 4, 3);
    private static final Stroke SOLID_STROKE = DrawContext.solidStroke(1.8);
    private static final double MARK_RADIUS = 8;
    private static final double MARGIN = 8;
    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** From the middle of a line down to where its letters stand, pixels. */
    private static final double BASELINE_OFFSET = 4.5;

    private static final double SAMPLE_LENGTH = 26;

    private ReferenceOverlayPainter() {}

    /** Paints all of its path. */
    static void paintPath(DrawContext brush, ReferenceOverlay ghost) {
        PathPainter.paint(
                brush,
                ghost.run().path(),
                PathStyle.REFERENCE,
                0,
                Integer.MAX_VALUE,
                brush.camera().bounds());
    }

    /**
     * Paints its robot where it was; what lives belongs above it.
     *
     * @param brush where to
     * @param ghost the earlier run
     * @param world of the frame that shows
     */
    public static void paintRobot(DrawContext brush, ReferenceOverlay ghost, Snapshot world) {
        RobotSpec robot = world.robot();
        AffineTransform frame = RigidMotion.poseTransform(ghost.poseAt(world.time()));
        Color colour = brush.palette().reference();
        brush.draw(
                brush.toScreen(
                        new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width()),
                        frame),
                colour,
                DASHED_STROKE);
        brush.draw(brush.toScreen(arrow(robot), frame), colour, SOLID_STROKE);
    }

    /**
     * Paints the mark where the two first differ, if they do, and the caption.
     *
     * @param brush where to
     * @param ghost the earlier run
     */
    public static void paintAnnotations(DrawContext brush, ReferenceOverlay ghost) {
        ghost.divergenceTick()
                .ifPresent(tick -> paintMark(
                        brush,
                        ghost.divergenceLabel(),
                        brush.camera().toScreen(ghost.run().pose(tick).position())));
        paintCaption(brush, ghost);
    }

    private static Shape arrow(RobotSpec robot) {
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(0, robot.width() * 0.25);
        arrow.lineTo(robot.length() * 0.3, 0);
        arrow.lineTo(0, -robot.width() * 0.25);
        return arrow;
    }

    /** A diamond with a line across. */
    private static void paintMark(DrawContext brush, String text, Vector2 at) {
        Color colour = brush.palette().reference();
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(at.x() - MARK_RADIUS, at.y());
        diamond.lineTo(at.x(), at.y() - MARK_RADIUS);
        diamond.lineTo(at.x() + MARK_RADIUS, at.y());
        diamond.lineTo(at.x(), at.y() + MARK_RADIUS);
        diamond.closePath();
        brush.draw(diamond, brush.palette().canvas(), DrawContext.HALO_STROKE);
        brush.draw(diamond, colour, SOLID_STROKE);
        brush.draw(
                new Line2D.Double(
                        at.x() - MARK_RADIUS / 2,
                        at.y() + MARK_RADIUS / 2,
                        at.x() + MARK_RADIUS / 2,
                        at.y() - MARK_RADIUS / 2),
                colour,
                SOLID_STROKE);
        brush.drawLabel(text, at.x(), at.y() - MARK_RADIUS - brush.scaleToFont(LINE_HEIGHT) / 2, colour);
    }

    /** In the lower left corner, with a sample of the robot's outline. */
    private static void paintCaption(DrawContext brush, ReferenceOverlay ghost) {
        double text = ghost.caption().stream()
                .mapToDouble(words -> brush.measureText(words).getWidth())
                .max()
                .orElse(0);
        double line = brush.scaleToFont(LINE_HEIGHT);
        double height = line * ghost.caption().size() + PADDING;
        double top = Math.rint(brush.camera().height() - MARGIN - height) + 0.5;
        Shape badge = new RoundRectangle2D.Double(
                MARGIN + 0.5, top, Math.ceil(text + SAMPLE_LENGTH + 3 * PADDING), height, 8, 8);
        brush.fill(badge, brush.palette().canvas());
        brush.draw(badge, brush.palette().reference(), DrawContext.solidStroke(1));
        double middle = top + (PADDING + line) / 2;
        brush.draw(
                new Line2D.Double(MARGIN + PADDING, middle, MARGIN + PADDING + SAMPLE_LENGTH, middle),
                brush.palette().reference(),
                DASHED_STROKE);
        for (int i = 0; i < ghost.caption().size(); i++) {
            brush.drawText(
                    ghost.caption().get(i),
                    MARGIN + 2 * PADDING + SAMPLE_LENGTH,
                    middle + brush.scaleToFont(BASELINE_OFFSET) + i * line,
                    brush.palette().text());
        }
    }
}
