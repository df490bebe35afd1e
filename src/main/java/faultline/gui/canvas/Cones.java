package faultline.gui.canvas;

import faultline.geometry.Sector;
import faultline.geometry.Vec;
import faultline.paint.Camera;
import faultline.world.SensorSnapshot;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.Optional;

/** Finds the cone, its rim and its edges under the mouse. */
final class Cones {

    private static final double TOLERANCE = 5;

    private Cones() {
    }

    /** The sensor whose cone is under a place of the picture; of several the one whose axis is nearest. */
    static Optional<SensorSnapshot> at(Camera camera, List<SensorSnapshot> sensors, Vec screen) {
        Vec point = camera.toWorld(screen);
        return sensors.stream().filter(sensor -> contains(sensor.sector(), point))
                .max((a, b) -> Double.compare(along(a.sector(), point), along(b.sector(), point)));
    }

    private static boolean contains(Sector sector, Vec point) {
        return point.distanceTo(sector.apex()) <= sector.range() && along(sector, point) >= sector.cosHalf();
    }

    /** The cosine of the angle between the axis and the way to a point. */
    private static double along(Sector sector, Vec point) {
        Vec way = point.minus(sector.apex());
        return way.dot(sector.axis()) / Math.max(way.length(), Double.MIN_NORMAL);
    }

    static boolean isOnRim(Camera camera, Sector sector, Vec screen) {
        Vec point = camera.toWorld(screen);
        double off = Math.abs(point.distanceTo(sector.apex()) - sector.range());
        return off * camera.scale() <= TOLERANCE && along(sector, point) >= sector.cosHalf();
    }

    static boolean isOnEdge(Camera camera, Sector sector, Vec screen) {
        return isOn(camera, sector, sector.leftEdge(), screen) || isOn(camera, sector, sector.rightEdge(), screen);
    }

    private static boolean isOn(Camera camera, Sector sector, Vec edge, Vec screen) {
        Vec from = camera.toScreen(sector.apex());
        Vec to = camera.toScreen(sector.apex().plus(edge.times(sector.range())));
        return Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), screen.x(), screen.y()) <= TOLERANCE;
    }
}
