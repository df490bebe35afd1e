package faultline.paint;

import faultline.geometry.RigidMotion;
import faultline.geometry.Vec;
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

/** Paints an earlier run beside the one that shows: its robot as a dashed outline, a mark where the two first differ, and a caption. */
public final class GhostPainter {

    private static final Stroke DASHED = Brush.dashed(1.6, 4, 3);
    private static final Stroke SOLID = Brush.solid(1.8);
    private static final double MARK = 8;
    private static final double FROM_EDGE = 8;
    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** From the middle of a line down to where its letters stand, pixels. */
    private static final double BASE = 4.5;
    private static final double SAMPLE = 26;

    private GhostPainter() {
    }

    /** Paints all of its path. */
    static void paintPath(Brush brush, Ghost ghost) {
        PathPainter.paint(brush, ghost.run().path(), PathStyle.GHOST, 0, Integer.MAX_VALUE, brush.camera().bounds());
    }

    /**
     * Paints its robot where it was; what lives belongs above it.
     *
     * @param brush where to
     * @param ghost the earlier run
     * @param world of the frame that shows
     */
    public static void paintBeneath(Brush brush, Ghost ghost, Snapshot world) {
        RobotSpec robot = world.robot();
        AffineTransform frame = RigidMotion.to(ghost.at(world.time()));
        Color colour = brush.palette().ghost();
        brush.draw(brush.onScreen(new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width()), frame),
                colour, DASHED);
        brush.draw(brush.onScreen(arrow(robot), frame), colour, SOLID);
    }

    /**
     * Paints the mark where the two first differ, if they do, and the caption.
     *
     * @param brush where to
     * @param ghost the earlier run
     */
    public static void paintAbove(Brush brush, Ghost ghost) {
        ghost.divergence().ifPresent(tick -> paintMark(brush, ghost.mark(), brush.camera().toScreen(ghost.run().pose(tick).position())));
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
    private static void paintMark(Brush brush, String text, Vec at) {
        Color colour = brush.palette().ghost();
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(at.x() - MARK, at.y());
        diamond.lineTo(at.x(), at.y() - MARK);
        diamond.lineTo(at.x() + MARK, at.y());
        diamond.lineTo(at.x(), at.y() + MARK);
        diamond.closePath();
        brush.draw(diamond, brush.palette().canvas(), Brush.HALO);
        brush.draw(diamond, colour, SOLID);
        brush.draw(new Line2D.Double(at.x() - MARK / 2, at.y() + MARK / 2, at.x() + MARK / 2, at.y() - MARK / 2), colour, SOLID);
        brush.label(text, at.x(), at.y() - MARK - brush.enlarged(LINE_HEIGHT) / 2, colour);
    }

    /** In the lower left corner, with a sample of the robot's outline. */
    private static void paintCaption(Brush brush, Ghost ghost) {
        double text = ghost.caption().stream().mapToDouble(words -> brush.measure(words).getWidth()).max().orElse(0);
        double line = brush.enlarged(LINE_HEIGHT);
        double height = line * ghost.caption().size() + PADDING;
        double top = Math.rint(brush.camera().height() - FROM_EDGE - height) + 0.5;
        Shape badge = new RoundRectangle2D.Double(FROM_EDGE + 0.5, top, Math.ceil(text + SAMPLE + 3 * PADDING), height, 8, 8);
        brush.fill(badge, brush.palette().canvas());
        brush.draw(badge, brush.palette().ghost(), Brush.solid(1));
        double middle = top + (PADDING + line) / 2;
        brush.draw(new Line2D.Double(FROM_EDGE + PADDING, middle, FROM_EDGE + PADDING + SAMPLE, middle), brush.palette().ghost(), DASHED);
        for (int i = 0; i < ghost.caption().size(); i++) {
            brush.text(ghost.caption().get(i), FROM_EDGE + 2 * PADDING + SAMPLE, middle + brush.enlarged(BASE) + i * line, brush.palette().text());
        }
    }
}
