package faultline.paint.plot;

import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vec;
import faultline.paint.ObstacleOutlines;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** A part of the world drawn to scale, seen from above: what scenes in figures are made of. */
public final class Plan {

    private static final double FLATNESS = 0.001;
    /** Points of a path nearer than this to the last one are left out, pixels. */
    private static final double THINNING = 0.5;
    private static final int ARC_POINTS = 24;

    private final Drawing drawing;
    private final Theme theme;
    private final Area area;
    private final Rectangle2D bounds;
    private final double scale;

    /**
     * A plan.
     *
     * @param drawing where to
     * @param area that it fills as far as its proportions allow
     * @param bounds what part of the world it shows, metres, y the lower edge
     * @param theme its colours
     */
    public Plan(Drawing drawing, Area area, Rectangle2D bounds, Theme theme) {
        this.drawing = drawing;
        this.theme = theme;
        this.area = area;
        this.bounds = bounds;
        this.scale = Math.min(area.width() / bounds.getWidth(), area.height() / bounds.getHeight());
    }

    /**
     * Where a point of the world is in the picture.
     *
     * @param world metres
     * @return pixels
     */
    public Vec place(Vec world) {
        return new Vec(area.x() + area.width() / 2 + scale * (world.x() - bounds.getCenterX()),
                area.y() + area.height() / 2 - scale * (world.y() - bounds.getCenterY()));
    }

    /**
     * Draws an obstacle.
     *
     * @param obstacle as it stands
     */
    public void obstacle(Obstacle obstacle) {
        List<Vec> outline = new ArrayList<>();
        double[] point = new double[6];
        for (PathIterator path = ObstacleOutlines.inWorld(obstacle).getPathIterator(null, FLATNESS); !path.isDone(); path.next()) {
            if (path.currentSegment(point) != PathIterator.SEG_CLOSE) {
                outline.add(new Vec(point[0], point[1]));
            }
        }
        boolean open = obstacle.shape() instanceof ObstacleShape.Wall;
        if (!open) {
            drawing.fill(places(outline), theme.palette().obstacle());
        }
        drawing.stroke(places(outline), !open, Pen.solid(theme.palette().obstacleOutline(), open ? 2.5 : 1.2));
    }

    /**
     * Draws the wall around a world.
     *
     * @param width of the world, metres
     * @param height of the world, metres
     */
    public void enclosure(double width, double height) {
        line(List.of(Vec.ZERO, new Vec(width, 0), new Vec(width, height), new Vec(0, height), Vec.ZERO),
                Pen.solid(theme.palette().obstacleOutline(), 2.5));
    }

    /**
     * Draws a robot: platform, wheels, and an arrow ahead.
     *
     * @param robot as built
     * @param pose where it stands
     * @param opacity from 0, not there, to 1
     */
    public void robot(RobotSpec robot, Pose pose, double opacity) {
        Pen outline = Pen.solid(Theme.faint(theme.palette().robotOutline(), opacity), 1.2);
        for (double x : new double[] {-0.28, 0.28}) {
            for (double y : new double[] {-0.5, 0.5}) {
                Vec hub = new Vec(x * robot.length(), y * robot.track());
                drawing.fill(box(pose, hub, 0.26 * robot.length(), 0.14 * robot.width()), Theme.faint(theme.palette().robotOutline(), opacity));
            }
        }
        List<Vec> body = box(pose, Vec.ZERO, robot.length(), robot.width());
        drawing.fill(body, Theme.faint(theme.palette().robot(), 0.55 * opacity));
        drawing.stroke(body, true, outline);
        arrow(pose.toOuter(new Vec(-0.15 * robot.length(), 0)), pose.toOuter(new Vec(0.38 * robot.length(), 0)), outline);
    }

    private List<Vec> box(Pose pose, Vec middle, double length, double width) {
        double x = length / 2;
        double y = width / 2;
        return places(List.of(new Vec(x, y), new Vec(-x, y), new Vec(-x, -y), new Vec(x, -y)).stream().map(middle::plus).map(pose::toOuter).toList());
    }

    /**
     * Draws a sensor's cone.
     *
     * @param cone in the world
     * @param style of its colour, from 0
     */
    public void cone(Sector cone, int style) {
        double half = StrictMath.atan2(cone.sinHalf(), cone.cosHalf());
        List<Vec> outline = new ArrayList<>();
        outline.add(cone.apex());
        outline.addAll(arc(cone.apex(), cone.range(), cone.axis().angle() - half, cone.axis().angle() + half));
        drawing.fill(places(outline), Theme.faint(theme.series(style), 0.16));
        drawing.stroke(places(outline), true, Pen.solid(theme.series(style), 0.9));
    }

    /**
     * Points along an arc.
     *
     * @param centre metres
     * @param radius metres
     * @param from radians
     * @param to radians
     * @return from the one end to the other
     */
    public static List<Vec> arc(Vec centre, double radius, double from, double to) {
        return IntStream.rangeClosed(0, ARC_POINTS)
                .mapToObj(i -> centre.plus(Vec.direction(from + (to - from) * i / ARC_POINTS).times(radius))).toList();
    }

    /**
     * Draws a line through points of the world; points that lie all but on one another are left out.
     *
     * @param points metres
     * @param pen what with
     */
    public void line(List<Vec> points, Pen pen) {
        List<Vec> thinned = new ArrayList<>();
        for (Vec point : places(points)) {
            if (thinned.isEmpty() || point.distanceTo(thinned.get(thinned.size() - 1)) >= THINNING) {
                thinned.add(point);
            }
        }
        drawing.stroke(thinned, false, pen);
    }

    /**
     * Draws an arrow.
     *
     * @param from metres
     * @param to metres, where its head is
     * @param pen what with
     */
    public void arrow(Vec from, Vec to, Pen pen) {
        line(List.of(from, to), pen);
        Arrowhead.paint(drawing, place(from), place(to), pen);
    }

    /**
     * Writes beside a point of the world.
     *
     * @param text what
     * @param at metres
     * @param right how far to the right, pixels
     * @param down how far down, pixels
     * @param style how
     */
    public void label(String text, Vec at, double right, double down, TextStyle style) {
        drawing.text(text, place(at).plus(new Vec(right, down)), style);
    }

    /**
     * Marks a point of the world.
     *
     * @param at metres
     * @param radius pixels
     */
    public void dot(Vec at, double radius) {
        drawing.disc(place(at), radius, theme.palette().text());
    }

    /**
     * Circles a point of the world.
     *
     * @param at metres
     * @param radius pixels
     */
    public void ring(Vec at, double radius) {
        drawing.ring(place(at), radius, Pen.solid(theme.palette().hit(), 1.8));
    }

    /**
     * Draws a bar of a length.
     *
     * @param metres how long it is
     * @param right of its right end, from the area's left, pixels
     * @param bottom from the area's upper edge, pixels
     */
    public void scaleBar(double metres, double right, double bottom) {
        Vec end = new Vec(area.x() + right, area.y() + bottom);
        Vec start = end.minus(new Vec(metres * scale, 0));
        Pen pen = Pen.solid(theme.palette().text(), 1.5);
        Vec tick = new Vec(0, 4);
        drawing.stroke(List.of(start.minus(tick), start, end, end.minus(tick)), false, pen);
        TextStyle style = TextStyle.plain(11, theme.palette().text()).anchored(TextStyle.Anchor.MIDDLE);
        drawing.text(Axis.name(metres) + " m", start.plus(end).times(0.5).minus(new Vec(0, 6)), style);
    }

    private List<Vec> places(List<Vec> points) {
        return points.stream().map(this::place).toList();
    }
}
