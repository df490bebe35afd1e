package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.surface.Arrowhead;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.Drawing;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.TextStyle;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** A part of the world drawn to scale, seen from above: what scenes in figures are made of. */
public final class PlanView {

    private static final double FLATNESS = 0.001;
    /** Points of a path nearer than this to the last one are left out, pixels. */
    private static final double THINNING = 0.5;

    private static final int ARC_POINTS = 24;

    private final Drawing drawing;
    private final ChartStyle theme;
    private final PixelRectangle area;
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
    public PlanView(Drawing drawing, PixelRectangle area, Rectangle2D bounds, ChartStyle theme) {
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
    public Vector2 toPicture(Vector2 world) {
        return new Vector2(
                area.x() + area.width() / 2 + scale * (world.x() - bounds.getCenterX()),
                area.y() + area.height() / 2 - scale * (world.y() - bounds.getCenterY()));
    }

    /**
     * Draws an obstacle.
     *
     * @param obstacle as it stands
     */
    public void drawObstacle(Obstacle obstacle) {
        List<Vector2> outline = new ArrayList<>();
        double[] point = new double[6];
        for (PathIterator path = ObstacleOutlines.worldShape(obstacle).getPathIterator(null, FLATNESS);
                !path.isDone();
                path.next()) {
            if (path.currentSegment(point) != PathIterator.SEG_CLOSE) {
                outline.add(new Vector2(point[0], point[1]));
            }
        }
        boolean open = obstacle.shape() instanceof ObstacleShape.Wall;
        if (!open) {
            drawing.fillPolygon(toPicturePoints(outline), theme.palette().obstacle());
        }
        drawing.drawPolyline(
                toPicturePoints(outline), !open, LineStyle.solid(theme.palette().obstacleOutline(), open ? 2.5 : 1.2));
    }

    /**
     * Draws the wall around a world.
     *
     * @param width of the world, metres
     * @param height of the world, metres
     */
    public void drawEnclosure(double width, double height) {
        drawLine(
                List.of(
                        Vector2.ZERO,
                        new Vector2(width, 0),
                        new Vector2(width, height),
                        new Vector2(0, height),
                        Vector2.ZERO),
                LineStyle.solid(theme.palette().obstacleOutline(), 2.5));
    }

    /**
     * Draws a robot: platform, wheels, and an arrow ahead.
     *
     * @param robot as built
     * @param pose where it stands
     * @param opacity from 0, not there, to 1
     */
    public void drawRobot(RobotSpec robot, Pose pose, double opacity) {
        LineStyle outline =
                LineStyle.solid(ChartStyle.withOpacity(theme.palette().robotOutline(), opacity), 1.2);
        for (double x : new double[] {-0.28, 0.28}) {
            for (double y : new double[] {-0.5, 0.5}) {
                Vector2 hub = new Vector2(x * robot.length(), y * robot.track());
                drawing.fillPolygon(
                        rectangle(pose, hub, 0.26 * robot.length(), 0.14 * robot.width()),
                        ChartStyle.withOpacity(theme.palette().robotOutline(), opacity));
            }
        }
        List<Vector2> body = rectangle(pose, Vector2.ZERO, robot.length(), robot.width());
        drawing.fillPolygon(body, ChartStyle.withOpacity(theme.palette().robot(), 0.55 * opacity));
        drawing.drawPolyline(body, true, outline);
        drawArrow(
                pose.toParent(new Vector2(-0.15 * robot.length(), 0)),
                pose.toParent(new Vector2(0.38 * robot.length(), 0)),
                outline);
    }

    private List<Vector2> rectangle(Pose pose, Vector2 middle, double length, double width) {
        double x = length / 2;
        double y = width / 2;
        return toPicturePoints(
                List.of(new Vector2(x, y), new Vector2(-x, y), new Vector2(-x, -y), new Vector2(x, -y)).stream()
                        .map(middle::plus)
                        .map(pose::toParent)
                        .toList());
    }

    /**
     * Draws a sensor's cone.
     *
     * @param cone in the world
     * @param style of its colour, from 0
     */
    public void drawCone(Sector cone, int style) {
        double half = StrictMath.atan2(cone.sinHalf(), cone.cosHalf());
        List<Vector2> outline = new ArrayList<>();
        outline.add(cone.apex());
        outline.addAll(arcPoints(
                cone.apex(),
                cone.range(),
                cone.axis().angle() - half,
                cone.axis().angle() + half));
        drawing.fillPolygon(toPicturePoints(outline), ChartStyle.withOpacity(theme.series(style), 0.16));
        drawing.drawPolyline(toPicturePoints(outline), true, LineStyle.solid(theme.series(style), 0.9));
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
    public static List<Vector2> arcPoints(Vector2 centre, double radius, double from, double to) {
        return IntStream.rangeClosed(0, ARC_POINTS)
                .mapToObj(i -> centre.plus(
                        Vector2.direction(from + (to - from) * i / ARC_POINTS).times(radius)))
                .toList();
    }

    /**
     * Draws a line through points of the world; points that lie all but on one another are left out.
     *
     * @param points metres
     * @param pen what with
     */
    public void drawLine(List<Vector2> points, LineStyle pen) {
        List<Vector2> thinned = new ArrayList<>();
        for (Vector2 point : toPicturePoints(points)) {
            if (thinned.isEmpty() || point.distanceTo(thinned.get(thinned.size() - 1)) >= THINNING) {
                thinned.add(point);
            }
        }
        drawing.drawPolyline(thinned, false, pen);
    }

    /**
     * Draws an arrow.
     *
     * @param from metres
     * @param to metres, where its head is
     * @param pen what with
     */
    public void drawArrow(Vector2 from, Vector2 to, LineStyle pen) {
        drawLine(List.of(from, to), pen);
        Arrowhead.paint(drawing, toPicture(from), toPicture(to), pen);
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
    public void drawLabel(String text, Vector2 at, double right, double down, TextStyle style) {
        drawing.drawText(text, toPicture(at).plus(new Vector2(right, down)), style);
    }

    /**
     * Marks a point of the world.
     *
     * @param at metres
     * @param radius pixels
     */
    public void drawDot(Vector2 at, double radius) {
        drawing.fillCircle(toPicture(at), radius, theme.palette().text());
    }

    /**
     * Circles a point of the world.
     *
     * @param at metres
     * @param radius pixels
     */
    public void drawCircle(Vector2 at, double radius) {
        drawing.drawCircle(
                toPicture(at), radius, LineStyle.solid(theme.palette().contact(), 1.8));
    }

    /**
     * Draws a bar of a length.
     *
     * @param metres how long it is
     * @param right of its right end, from the area's left, pixels
     * @param bottom from the area's upper edge, pixels
     */
    public void drawScaleBar(double metres, double right, double bottom) {
        Vector2 end = new Vector2(area.x() + right, area.y() + bottom);
        Vector2 start = end.minus(new Vector2(metres * scale, 0));
        LineStyle pen = LineStyle.solid(theme.palette().text(), 1.5);
        Vector2 tick = new Vector2(0, 4);
        drawing.drawPolyline(List.of(start.minus(tick), start, end, end.minus(tick)), false, pen);
        TextStyle style = TextStyle.plain(11, theme.palette().text()).withAnchor(TextStyle.Anchor.MIDDLE);
        drawing.drawText(
                Axis.formatTick(metres) + " m", start.plus(end).times(0.5).minus(new Vector2(0, 6)), style);
    }

    private List<Vector2> toPicturePoints(List<Vector2> points) {
        return points.stream().map(this::toPicture).toList();
    }
}
