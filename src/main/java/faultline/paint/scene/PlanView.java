package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.NiceSteps;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A part of the world seen from above in a figure, to scale. Robots, cones and obstacles look as in the window, because
 * the same painters paint them; lines, arrows and labels are added in world coordinates. No text is measured.
 */
public final class PlanView {

    /** Points of a line nearer than this to the last one are omitted, pixels. */
    private static final double THINNING = 0.5;

    private static final int ARC_POINTS = 24;
    private static final double ARROWHEAD_LENGTH = 8;
    private static final double ARROWHEAD_WIDTH = 6;

    private final Surface surface;
    private final PixelRectangle area;
    private final DrawContext context;

    /**
     * Creates a view of a part of the world, metres, y its lower edge. It fills the area as far as its proportions
     * allow.
     */
    public PlanView(Surface surface, PixelRectangle area, Rectangle2D bounds, ChartStyle style) {
        this.surface = surface;
        this.area = area;
        this.context = new DrawContext(surface, Camera.fit(bounds, area), style.palette(), DrawContext.DEFAULT_FONT);
    }

    /** Returns the position of a point of the world in the picture, pixels. */
    public Vector2 toPicture(Vector2 world) {
        return context.camera().toScreen(world);
    }

    /** Draws the bounds of a world and its obstacles. */
    public void drawWorld(WorldSpec world) {
        if (world.enclosed()) {
            BoundsPainter.paint(context, world.width(), world.height(), true);
        }
        world.obstacles().forEach(this::drawObstacle);
    }

    public void drawObstacle(Obstacle obstacle) {
        ObstaclePainter.paintShape(context, obstacle);
    }

    /** Draws a robot; opacity in [0, 1]. */
    public void drawRobot(RobotSpec robot, Pose pose, double opacity) {
        RobotPainter.paint(context, robot, pose, opacity);
    }

    /** Draws a sensor's cone in the colour of a sensor, whose index in the robot is given. */
    public void drawCone(Sector cone, int index) {
        SensorPainter.paintCone(context, cone, context.palette().sensorColours(index));
    }

    /** Returns points along an arc from one angle to another, radians; centre and radius in metres. */
    public static List<Vector2> arcPoints(Vector2 centre, double radius, double from, double to) {
        return IntStream.rangeClosed(0, ARC_POINTS)
                .mapToObj(i -> centre.plus(
                        Vector2.direction(from + (to - from) * i / ARC_POINTS).times(radius)))
                .toList();
    }

    /** Draws a line through points of the world, metres; points that almost coincide are omitted. */
    public void drawLine(List<Vector2> points, LineStyle style) {
        List<Vector2> thinned = new ArrayList<>();
        for (Vector2 point : points) {
            Vector2 next = toPicture(point);
            if (thinned.isEmpty() || next.distanceTo(thinned.get(thinned.size() - 1)) >= THINNING) {
                thinned.add(next);
            }
        }
        if (thinned.size() > 1) {
            surface.draw(Shapes.polyline(thinned), style);
        }
    }

    /** Draws an arrow from one point of the world to another, metres. */
    public void drawArrow(Vector2 from, Vector2 to, LineStyle style) {
        drawLine(List.of(from, to), style);
        Vector2 shaft = toPicture(to).minus(toPicture(from));
        Vector2 direction = shaft.times(1 / shaft.length());
        surface.fill(Shapes.arrowhead(toPicture(to), direction, ARROWHEAD_LENGTH, ARROWHEAD_WIDTH), style.colour());
    }

    /** Draws a text at an offset to the right and downwards, pixels, from a point of the world, metres. */
    public void drawLabel(String text, Vector2 at, double right, double down, TextStyle style) {
        surface.drawText(text, toPicture(at).plus(new Vector2(right, down)), style);
    }

    /** Draws a dot at a point of the world; radius in pixels. */
    public void drawDot(Vector2 at, double radius) {
        surface.fill(Shapes.circle(toPicture(at), radius), context.palette().text());
    }

    /** Draws a ring around a point of the world; radius in pixels. */
    public void drawRing(Vector2 at, double radius) {
        surface.draw(
                Shapes.circle(toPicture(at), radius),
                LineStyle.solid(context.palette().contact(), 1.8));
    }

    /**
     * Draws a scale bar of a nice length, metres, with the length above. Its right end is at a distance from the left
     * and the upper edge of the area, pixels.
     */
    public void drawScaleBar(double metres, double right, double bottom) {
        double length = metres * context.camera().scale();
        Vector2 end = new Vector2(area.x() + right, area.y() + bottom);
        surface.draw(
                ScaleBarPainter.barShape(end.x() - length, end.x(), end.y()),
                LineStyle.solid(context.palette().text(), 1.5));
        surface.drawText(
                NiceSteps.format(metres),
                end.minus(new Vector2(length / 2, 6)),
                TextStyle.plain(11, context.palette().text()).withAnchor(TextStyle.Anchor.MIDDLE));
    }
}
