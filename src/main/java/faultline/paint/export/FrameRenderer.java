package faultline.paint.export;

import faultline.engine.Frame;
import faultline.engine.RobotPath;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;

/** Renders frames as pictures without a display, with the painter of the window. */
public final class FrameRenderer {

    /** The margin around the world, pixels: for the band, the scale bar below the band and the badge above. */
    private static final double MARGIN = 24;

    private static final double MIN_ASPECT = 0.25;
    private static final double MAX_ASPECT = 2;

    private FrameRenderer() {}

    /** Returns the height of a picture that shows a world of usual proportions without empty space, pixels. */
    public static int heightFor(Frame frame, int width) {
        double aspect = frame.snapshot().height() / frame.snapshot().width();
        return (int) (width * Math.max(MIN_ASPECT, Math.min(MAX_ASPECT, aspect)));
    }

    /**
     * Renders a whole world and the robot's path with the default layers as a new opaque picture; width and height in
     * pixels, positive.
     */
    public static BufferedImage render(Frame frame, Palette palette, int width, int height) {
        return request(frame, palette, width, height).toImage(1);
    }

    /**
     * Returns the description of the picture of a whole world and the robot's path with the default layers; sizes in
     * pixels, positive.
     */
    public static RenderRequest request(Frame frame, Palette palette, int width, int height) {
        Rectangle2D bounds = bounds(frame.snapshot());
        if (!frame.snapshot().enclosed()) {
            RobotPath path = frame.path();
            for (int i = 0; i < path.size(); i++) {
                bounds.add(path.x(i), path.y(i));
            }
        }
        return request(frame, bounds, palette, width, height);
    }

    /**
     * Returns the description of the picture of a part of the world, given its bounds, metres, with the default layers;
     * sizes in pixels, positive.
     */
    public static RenderRequest request(Frame frame, Rectangle2D bounds, Palette palette, int width, int height) {
        return new RenderRequest(frame, Camera.fit(bounds, MARGIN, width, height), palette, Layer.defaults());
    }

    /** Returns the camera that shows a whole world and the robot with a margin; sizes in pixels, positive. */
    public static Camera fitCamera(Snapshot world, int width, int height) {
        return Camera.fit(bounds(world), MARGIN, width, height);
    }

    /**
     * Returns the camera that shows a whole world and the cones of the robot, which may end beyond its walls, with a
     * margin; width and height in pixels, positive.
     */
    public static Camera fitCameraWithCones(Snapshot world, int width, int height) {
        Rectangle2D bounds = bounds(world);
        for (SensorSnapshot sensor : world.sensors()) {
            bounds = bounds.createUnion(coneBounds(sensor.sector()));
        }
        return Camera.fit(bounds, MARGIN, width, height);
    }

    private static Rectangle2D coneBounds(Sector cone) {
        double half = Math.toDegrees(Math.atan2(cone.sinHalf(), cone.cosHalf()));
        double bearing = Math.toDegrees(cone.axis().angle());
        double radius = cone.range();
        // The angles of an arc are clockwise where y is upward.
        return new Arc2D.Double(
                        cone.apex().x() - radius,
                        cone.apex().y() - radius,
                        2 * radius,
                        2 * radius,
                        -bearing - half,
                        2 * half,
                        Arc2D.PIE)
                .getBounds2D();
    }

    /** Returns the bounds of the world and of everything outside of it, the robot included, metres. */
    public static Rectangle2D bounds(Snapshot world) {
        Rectangle2D bounds = new Rectangle2D.Double(0, 0, world.width(), world.height());
        for (Obstacle obstacle : world.obstacles()) {
            if (!isWithin(bounds, obstacle)) {
                bounds =
                        bounds.createUnion(ObstacleOutlines.worldShape(obstacle).getBounds2D());
            }
        }
        return world.enclosed() ? bounds : bounds.createUnion(robotBounds(world));
    }

    private static Rectangle2D robotBounds(Snapshot world) {
        RobotSpec robot = world.robot();
        Shape platform = new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width());
        return RigidMotion.poseTransform(world.pose())
                .createTransformedShape(platform)
                .getBounds2D();
    }

    /** Returns whether a circle around an obstacle is within bounds, which is known sooner than its own bounds. */
    private static boolean isWithin(Rectangle2D bounds, Obstacle obstacle) {
        double radius = obstacle.shape().boundingRadius();
        double x = obstacle.pose().x() - radius;
        double y = obstacle.pose().y() - radius;
        return bounds.contains(x, y, 2 * radius, 2 * radius);
    }
}
