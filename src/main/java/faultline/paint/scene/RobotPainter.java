package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.Shapes;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;

/**
 * Paints the robot from above: a body between four wheels, an arrow ahead and a bar along its front. All of it lies
 * within the rectangle of the platform, which is what collides.
 */
final class RobotPainter {

    private static final Stroke OUTLINE_STROKE = DrawContext.solidStroke(1.4);

    /** The reach of the halo beyond the corners of the platform, pixels. */
    private static final double HALO_REACH = 11;

    private static final int HALO_ALPHA = 70;

    /** The length of the platform below which the arrow on it is too small to be seen, pixels. */
    private static final double MIN_CLEAR_LENGTH = 30;

    /** The length of the arrowhead on the halo, and how far it reaches beyond it, pixels. */
    private static final double HEADING_LENGTH = 11;

    private static final double HEADING_REACH = 7;

    private RobotPainter() {}

    /** Paints a disc with a ring in the colour of the robot around it, so that also a small robot is easy to find. */
    static void paintHalo(DrawContext context, RobotSpec robot, Pose pose) {
        double radius = haloRadius(context, robot);
        Vector2 centre = context.camera().toScreen(pose.position());
        context.fill(
                Shapes.circle(centre, radius),
                Palette.withAlpha(context.palette().robot(), HALO_ALPHA));
        context.drawRing(centre, radius, 1.8, context.palette().robot());
    }

    /** Returns the bounds of the platform, pixels. */
    static Rectangle2D bounds(DrawContext context, RobotSpec robot, Pose pose) {
        double cos = Math.abs(Math.cos(pose.heading()));
        double sin = Math.abs(Math.sin(pose.heading()));
        double width = context.camera().scale() * (robot.length() * cos + robot.width() * sin);
        double height = context.camera().scale() * (robot.length() * sin + robot.width() * cos);
        Vector2 centre = context.camera().toScreen(pose.position());
        return new Rectangle2D.Double(centre.x() - width / 2, centre.y() - height / 2, width, height);
    }

    static double haloRadius(DrawContext context, RobotSpec robot) {
        return context.camera().scale() * Math.hypot(robot.length(), robot.width()) / 2 + HALO_REACH;
    }

    /**
     * Paints an arrowhead on the halo where the robot is heading, if the arrow on the robot is too small to be seen.
     */
    static void paintHeading(DrawContext context, RobotSpec robot, Pose pose) {
        if (context.camera().scale() * robot.length() < MIN_CLEAR_LENGTH) {
            Vector2 ahead = new Vector2(Math.cos(pose.heading()), -Math.sin(pose.heading()));
            Vector2 tip = context.camera()
                    .toScreen(pose.position())
                    .plus(ahead.times(haloRadius(context, robot) + HEADING_REACH));
            Shape head = Shapes.arrowhead(tip, ahead, HEADING_LENGTH, HEADING_LENGTH);
            context.draw(head, context.palette().canvas(), DrawContext.HALO_STROKE);
            context.fill(head, context.palette().robotOutline());
        }
    }

    static void paint(DrawContext context, RobotSpec robot, Pose pose) {
        paint(context, robot, pose, 1);
    }

    /** Paints the robot; opacity in [0, 1]. */
    static void paint(DrawContext context, RobotSpec robot, Pose pose, double opacity) {
        AffineTransform frame = RigidMotion.poseTransform(pose);
        Color dark = ChartStyle.withOpacity(context.palette().robotOutline(), opacity);
        // The front wheels come first. Another order would change the bytes of drawings.
        for (int axle = 0; axle < 2; axle++) {
            for (MotorSide side : MotorSide.values()) {
                Vector2 centre = wheelCentres(robot, side).get(axle);
                context.fill(context.toScreen(wheel(robot, centre), frame), dark);
            }
        }
        Shape body = context.toScreen(body(robot), frame);
        context.fill(body, ChartStyle.withOpacity(context.palette().robot(), opacity));
        context.fill(context.toScreen(front(robot), frame), dark);
        context.fill(context.toScreen(arrow(robot), frame), dark);
        context.draw(body, dark, OUTLINE_STROKE);
    }

    private static Shape body(RobotSpec robot) {
        double side = robot.width() - 2 * wheelWidth(robot) * 0.7;
        double corner = Math.min(robot.length(), side) * 0.3;
        return new RoundRectangle2D.Double(-robot.length() / 2, -side / 2, robot.length(), side, corner, corner);
    }

    static double wheelWidth(RobotSpec robot) {
        return robot.width() * 0.16;
    }

    static double wheelLength(RobotSpec robot) {
        return robot.length() * 0.3;
    }

    /** Returns the centres of the two wheels of a side, in the robot's frame, metres. */
    static List<Vector2> wheelCentres(RobotSpec robot, MotorSide side) {
        double ahead = robot.length() * 0.27;
        double aside = (robot.width() - wheelWidth(robot)) / 2 * (side == MotorSide.LEFT ? 1 : -1);
        return List.of(new Vector2(ahead, aside), new Vector2(-ahead, aside));
    }

    private static Shape wheel(RobotSpec robot, Vector2 centre) {
        double length = wheelLength(robot);
        double width = wheelWidth(robot);
        return new RoundRectangle2D.Double(
                centre.x() - length / 2, centre.y() - width / 2, length, width, width * 0.7, width * 0.7);
    }

    private static Shape front(RobotSpec robot) {
        double thickness = robot.length() * 0.06;
        double side = robot.width() * 0.5;
        return new RoundRectangle2D.Double(
                robot.length() / 2 - 1.7 * thickness, -side / 2, thickness, side, thickness, thickness);
    }

    private static Shape arrow(RobotSpec robot) {
        return Shapes.polygon(List.of(
                new Vector2(robot.length() * 0.34, 0),
                new Vector2(robot.length() * 0.10, robot.width() * 0.17),
                new Vector2(robot.length() * 0.15, 0),
                new Vector2(robot.length() * 0.10, -robot.width() * 0.17)));
    }
}
