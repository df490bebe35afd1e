package faultline.paint.scene;

import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Line2D;

/**
 * A sensor's cone in the picture.
 *
 * @param apex pixels
 * @param startAngle the bearing of the edge on the right, degrees, counter-clockwise as seen, as {@link Arc2D} has them
 * @param extent the full angle, degrees
 * @param radius pixels
 * @param scale pixels per metre
 */
record ScreenSector(Vector2 apex, double startAngle, double extent, double radius, double scale) {

    static ScreenSector of(Camera camera, Sector sector) {
        double half = Math.toDegrees(Math.atan2(sector.sinHalf(), sector.cosHalf()));
        double bearing = Math.toDegrees(sector.axis().angle());
        return new ScreenSector(
                camera.toScreen(sector.apex()),
                bearing - half,
                2 * half,
                sector.range() * camera.scale(),
                camera.scale());
    }

    /** Returns the outline of the cone. */
    Shape outline() {
        return arc(radius, Arc2D.PIE);
    }

    /** Returns the arc at a distance from the apex, metres. */
    Shape arcAt(double metres) {
        return arc(metres * scale, Arc2D.OPEN);
    }

    private Shape arc(double r, int type) {
        return new Arc2D.Double(apex.x() - r, apex.y() - r, 2 * r, 2 * r, startAngle, extent, type);
    }

    /**
     * Returns the line from the apex to the arc at a fraction of the angle, from 0, the right edge, to 1, the left
     * edge.
     */
    Shape ray(double share) {
        Vector2 end = pointAt(share, radius);
        return new Line2D.Double(apex.x(), apex.y(), end.x(), end.y());
    }

    /** Returns the point at a fraction of the angle and a distance from the apex, pixels. */
    Vector2 pointAt(double share, double distance) {
        double bearing = Math.toRadians(startAngle + share * extent);
        return new Vector2(apex.x() + distance * Math.cos(bearing), apex.y() - distance * Math.sin(bearing));
    }
}
