package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.world.Snapshot;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Marks the wheels of a side whose motors are faulty: pale, and hatched or crossed out, with the names of the faults
 * beside the robot. Paints nothing if no motor is faulty.
 */
final class MotorFaultPainter {

    private static final Stroke OUTLINE_STROKE = DrawContext.solidStroke(1.4);
    private static final Stroke LINE_STROKE = DrawContext.solidStroke(1);
    /** The minimum size of a marked wheel, so that the hatching of a small robot can be seen, pixels. */
    private static final double MIN_LENGTH = 9;

    private static final double MIN_WIDTH = 7;
    /** The distance between two lines of the hatching, pixels. */
    private static final double STEP = 3;
    /** Between the halo of the robot and the label, pixels. */
    private static final double LABEL_GAP = 3;
    /** How far a label moves away from the robot to find a free place, pixels, and the steps of that. */
    private static final double MAX_SHIFT = 400;

    private static final double SHIFT_STEP = 4;

    private MotorFaultPainter() {}

    /** The label of a side with its bounding box, pixels. */
    record SideLabel(String text, Rectangle2D box) {}

    /** Paints the wheels of the sides that have faults, on top of the robot. */
    static void paintWheels(DrawContext context, Snapshot world) {
        for (MotorSide side : MotorSide.values()) {
            Set<MotorFaultKind> kinds = EnumSet.noneOf(MotorFaultKind.class);
            world.motorFaults().of(side).stream().map(MotorFault::kind).forEach(kinds::add);
            if (!kinds.isEmpty()) {
                for (Vector2 centre : RobotPainter.wheelCentres(world.robot(), side)) {
                    paintWheel(context, world.robot(), world.pose(), centre, kinds);
                }
            }
        }
    }

    private static void paintWheel(
            DrawContext context, RobotSpec robot, Pose pose, Vector2 centre, Set<MotorFaultKind> kinds) {
        double scale = context.camera().scale();
        double length = Math.max(RobotPainter.wheelLength(robot), MIN_LENGTH / scale);
        double width = Math.max(RobotPainter.wheelWidth(robot), MIN_WIDTH / scale);
        // A wheel that is enlarged grows away from the other one and from the body, which it would cover.
        double x = centre.x() + Math.signum(centre.x()) * (length - RobotPainter.wheelLength(robot)) / 2;
        double y = centre.y() + Math.signum(centre.y()) * (width - RobotPainter.wheelWidth(robot)) / 2;
        Rectangle2D wheel = new Rectangle2D.Double(x - length / 2, y - width / 2, length, width);
        AffineTransform frame = RigidMotion.poseTransform(pose);
        Color colour = context.palette().contact();
        Shape outline = context.toScreen(wheel, frame);
        context.fill(outline, context.palette().canvas());
        context.draw(context.toScreen(hatching(wheel, kinds, STEP / scale), frame), colour, LINE_STROKE);
        context.draw(outline, colour, OUTLINE_STROKE);
    }

    /** Returns lines across a wheel that drives less, lines along one that starts late, and a cross if it is dead. */
    private static Path2D hatching(Rectangle2D wheel, Set<MotorFaultKind> kinds, double step) {
        Path2D lines = new Path2D.Double();
        if (kinds.contains(MotorFaultKind.DEAD)) {
            lines.append(new Line2D.Double(wheel.getMinX(), wheel.getMinY(), wheel.getMaxX(), wheel.getMaxY()), false);
            lines.append(new Line2D.Double(wheel.getMinX(), wheel.getMaxY(), wheel.getMaxX(), wheel.getMinY()), false);
            return lines;
        }
        if (kinds.contains(MotorFaultKind.WEAK)) {
            int gaps = (int) Math.max(2, Math.round(wheel.getWidth() / step));
            for (int i = 1; i < gaps; i++) {
                double x = wheel.getX() + i * wheel.getWidth() / gaps;
                lines.append(new Line2D.Double(x, wheel.getMinY(), x, wheel.getMaxY()), false);
            }
        }
        if (kinds.contains(MotorFaultKind.DEAD_BAND)) {
            int gaps = (int) Math.max(2, Math.round(wheel.getHeight() / step));
            for (int i = 1; i < gaps; i++) {
                double y = wheel.getY() + i * wheel.getHeight() / gaps;
                lines.append(new Line2D.Double(wheel.getMinX(), y, wheel.getMaxX(), y), false);
            }
        }
        return lines;
    }

    /**
     * Returns the labels of the sides that have faults, within the picture: beside the halo of the robot, or so far
     * from it that they cover no other labels, whose bounding boxes are given, pixels. None if the robot is outside.
     */
    static List<SideLabel> labels(DrawContext context, Snapshot world, SceneLabels labels, List<Rectangle2D> others) {
        List<SideLabel> result = new ArrayList<>();
        if (!isInPicture(context, world)) {
            return result;
        }
        for (MotorSide side : MotorSide.values()) {
            String faults = names(world, side, labels).collect(Collectors.joining(", "));
            if (!faults.isEmpty()) {
                String text = labels.motors().apply(side) + ": " + faults;
                List<Rectangle2D> taken = new ArrayList<>(others);
                result.forEach(label -> taken.add(label.box()));
                result.add(new SideLabel(text, place(context, world, side, context.measureText(text), taken)));
            }
        }
        return result;
    }

    private static boolean isInPicture(DrawContext context, Snapshot world) {
        Vector2 centre = context.camera().toScreen(world.pose().position());
        double radius = RobotPainter.haloRadius(context, world.robot());
        return new Rectangle2D.Double(
                        0, 0, context.camera().width(), context.camera().height())
                .intersects(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    }

    private static Stream<String> names(Snapshot world, MotorSide side, SceneLabels labels) {
        return world.motorFaults().of(side).stream()
                .map(fault -> labels.faultName().apply(fault.kind()))
                .distinct();
    }

    private static Rectangle2D place(
            DrawContext context, Snapshot world, MotorSide side, Rectangle2D size, List<Rectangle2D> taken) {
        double nearest = RobotPainter.haloRadius(context, world.robot()) + LABEL_GAP;
        for (double distance = nearest; distance < nearest + MAX_SHIFT; distance += SHIFT_STEP) {
            Rectangle2D box = boxAt(context, world.pose(), side, size, distance);
            if (taken.stream().noneMatch(box::intersects)) {
                return box;
            }
        }
        return boxAt(context, world.pose(), side, size, nearest);
    }

    /**
     * Returns the box of a label whose edge is at a distance from the centre of the robot, pixels, or further inside.
     */
    private static Rectangle2D boxAt(
            DrawContext context, Pose pose, MotorSide side, Rectangle2D size, double distance) {
        double angle = pose.heading() + (side == MotorSide.LEFT ? Math.PI / 2 : -Math.PI / 2);
        Vector2 aside = new Vector2(Math.cos(angle), -Math.sin(angle));
        double clear = (Math.abs(aside.x()) * size.getWidth() + Math.abs(aside.y()) * size.getHeight()) / 2;
        Vector2 centre = context.camera().toScreen(pose.position()).plus(aside.times(distance + clear));
        return new Rectangle2D.Double(
                within(centre.x() - size.getWidth() / 2, context.camera().width() - size.getWidth()),
                within(centre.y() - size.getHeight() / 2, context.camera().height() - size.getHeight()),
                size.getWidth(),
                size.getHeight());
    }

    private static double within(double value, double max) {
        return Math.max(0, Math.min(value, max));
    }

    /** Paints the labels of the sides that have faults, where they do not cover other labels. */
    static void paintLabels(DrawContext context, Snapshot world, SceneLabels names, List<Rectangle2D> others) {
        for (SideLabel label : labels(context, world, names, others)) {
            context.drawLabel(
                    label.text(),
                    label.box().getCenterX(),
                    label.box().getCenterY(),
                    context.palette().text());
        }
    }
}
