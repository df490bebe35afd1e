package faultline.gui.canvas.tool;

import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.world.SensorSnapshot;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.Optional;

/** Finds the cone, its arc and its edges under the mouse. */
public final class ConeHitTest {

    private static final double TOLERANCE = 5;

    private ConeHitTest() {}

    /** Returns the sensor whose cone is at a position on the canvas; of several the one with the nearest axis. */
    public static Optional<SensorSnapshot> sensorAt(Camera camera, List<SensorSnapshot> sensors, Vector2 screen) {
        Vector2 point = camera.toWorld(screen);
        return sensors.stream()
                .filter(sensor -> contains(sensor.sector(), point))
                .max((a, b) -> Double.compare(cosineToAxis(a.sector(), point), cosineToAxis(b.sector(), point)));
    }

    private static boolean contains(Sector sector, Vector2 point) {
        return point.distanceTo(sector.apex()) <= sector.range() && cosineToAxis(sector, point) >= sector.cosHalf();
    }

    /** Returns the cosine of the angle between the axis and the direction to a point. */
    private static double cosineToAxis(Sector sector, Vector2 point) {
        Vector2 offset = point.minus(sector.apex());
        return offset.dot(sector.axis()) / Math.max(offset.length(), Double.MIN_NORMAL);
    }

    public static boolean isOnArc(Camera camera, Sector sector, Vector2 screen) {
        Vector2 point = camera.toWorld(screen);
        double off = Math.abs(point.distanceTo(sector.apex()) - sector.range());
        return off * camera.scale() <= TOLERANCE && cosineToAxis(sector, point) >= sector.cosHalf();
    }

    public static boolean isOnEdge(Camera camera, Sector sector, Vector2 screen) {
        return isOn(camera, sector, sector.leftEdge(), screen) || isOn(camera, sector, sector.rightEdge(), screen);
    }

    private static boolean isOn(Camera camera, Sector sector, Vector2 edge, Vector2 screen) {
        Vector2 from = camera.toScreen(sector.apex());
        Vector2 to = camera.toScreen(sector.apex().plus(edge.times(sector.range())));
        return Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), screen.x(), screen.y()) <= TOLERANCE;
    }
}
