package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;

/**
 * A sensor's cone that moves with the robot, and the static shapes that it may see while the robot stays near a pose.
 * Confined to the simulation thread.
 */
final class SensorCone {

    /** If the half angle is at least this, radians, all shapes around the sensor are kept. */
    private static final double MAX_WEDGE = 1.4;

    private static final double MARGIN = 1e-9;

    /** The horizon is never less than this unless the range is, metres. */
    private static final double MIN_HORIZON = 1;

    private static final double HORIZON_PER_DISTANCE = 1.4;

    private final NearShapes near = new NearShapes();
    private final double range;
    private final double cosHalf;
    private final double sinHalf;
    private final double specularTangent;
    private final RigidMotion mount;
    private final boolean outsideBody;
    private final SectorDistance cone;

    // A wider cone, set back, that contains all cones of this sensor while the robot stays near a pose.
    private final double travel;
    private final boolean narrow;
    private final double setback;
    private final double mountDistance;
    private double horizon;
    private final SectorDistance wedge;

    /**
     * Creates a cone.
     *
     * @param spec the sensor
     * @param specularAngle the greatest angle of incidence at which any flat surface is sensed, radians
     * @param robot the robot that carries it
     * @param maxTravel the maximum distance that the robot moves before {@link #collect} is called again, metres
     * @param maxTurn the maximum angle that it turns before that, radians
     */
    SensorCone(SensorSpec spec, double specularAngle, RobotSpec robot, double maxTravel, double maxTurn) {
        Vector2 position = spec.mountPosition();
        range = spec.range();
        cosHalf = StrictMath.cos(spec.cone() / 2);
        sinHalf = StrictMath.sin(spec.cone() / 2);
        specularTangent = ShapeOwner.tangent(specularAngle);
        outsideBody = Math.abs(position.x()) > robot.length() / 2 || Math.abs(position.y()) > robot.width() / 2;
        mount = RigidMotion.of(new Pose(position.x(), position.y(), spec.bearing()));
        cone = new SectorDistance(cosHalf, sinHalf, range);
        mountDistance = position.length();
        travel = maxTravel + maxTurn * mountDistance + MARGIN;
        horizon = Math.min(range, MIN_HORIZON);
        double half = spec.cone() / 2 + maxTurn + MARGIN;
        narrow = half < MAX_WEDGE;
        setback = narrow ? travel / StrictMath.sin(half) : 0;
        wedge = narrow
                ? new SectorDistance(StrictMath.cos(half), StrictMath.sin(half), range + travel + setback)
                : cone;
    }

    /** Returns the cone in the world. */
    Sector sector(RigidMotion robot) {
        return new Sector(robot.after(mount), cosHalf, sinHalf, range);
    }

    /** Returns whether the sensor is mounted beside the robot's body. */
    boolean isOutsideBody() {
        return outsideBody;
    }

    double apexX(RobotBody body) {
        return body.x() + body.cos() * mount.x() - body.sin() * mount.y();
    }

    double apexY(RobotBody body) {
        return body.y() + body.sin() * mount.x() + body.cos() * mount.y();
    }

    /**
     * Sets the horizon of the next {@link #collect} from the last measured distance: most shapes beyond a near wall
     * will not be measured soon.
     */
    void setHorizon(double lastDistance) {
        horizon = Math.min(range, Math.max(MIN_HORIZON, HORIZON_PER_DISTANCE * lastDistance));
    }

    /** Doubles the horizon. */
    void widenHorizon() {
        horizon = Math.min(range, 2 * horizon);
    }

    /** Returns the radius around the robot's centre within which {@link #collect} needs all shapes, metres. */
    double searchRadius() {
        return (mountDistance + horizon + travel + MARGIN) * (1 + 1e-12);
    }

    /** Returns whether a measured distance is certain, because nothing beyond the horizon could be nearer. */
    boolean isCertain(double distance) {
        return distance <= horizon || horizon >= range;
    }

    /** Returns whether this sensor certainly sees nothing but moving obstacles in the region of the last collection. */
    boolean seesNothing() {
        return near.isEmpty() && horizon >= range && !outsideBody;
    }

    /**
     * Collects the candidates that this sensor may see, up to the horizon, while the robot stays near a pose.
     *
     * @param candidates all shapes within the search radius, and perhaps others
     * @param robotX the x coordinate of the pose, metres
     * @param robotY the y coordinate of the pose, metres
     * @param cos the cosine of its heading
     * @param sin the sine of its heading
     */
    void collect(CandidateBuffer candidates, double robotX, double robotY, double cos, double sin) {
        near.clear();
        double x = robotX + cos * mount.x() - sin * mount.y();
        double y = robotY + sin * mount.x() + cos * mount.y();
        if (narrow) {
            double ux = cos * mount.cos() - sin * mount.sin();
            double uy = sin * mount.cos() + cos * mount.sin();
            wedge.moveTo(x - setback * ux, y - setback * uy, ux, uy);
        }
        for (int i = 0; i < candidates.size(); i++) {
            ConvexShape shape = candidates.shape(i);
            if (narrow && wedge.nearest(shape) == Double.POSITIVE_INFINITY) {
                continue;
            }
            double distance = shape.distanceTo(x, y);
            if (distance <= horizon + travel) {
                near.add(shape, tangent(candidates.owner(i)), distance);
            }
        }
        near.sort();
    }

    private double tangent(ShapeOwner owner) {
        return Math.min(specularTangent, owner.specularTangent());
    }

    /**
     * Returns the distance to the nearest shape in the cone, metres, or positive infinity.
     *
     * @param body the robot's body, near the pose of the collected shapes
     * @param driven the distance of its centre from that pose, metres
     * @param turned the angle between its heading and that of the pose, radians
     * @param moving the moving obstacles near it
     */
    double measure(RobotBody body, double driven, double turned, List<MovingObstacle> moving) {
        if (near.isEmpty() && moving.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double x = apexX(body);
        double y = apexY(body);
        cone.moveTo(
                x,
                y,
                body.cos() * mount.cos() - body.sin() * mount.sin(),
                body.sin() * mount.cos() + body.cos() * mount.sin());
        double least = near.nearest(cone, driven + turned * mountDistance + MARGIN);
        for (int i = 0; i < moving.size(); i++) {
            MovingObstacle mover = moving.get(i);
            if (mover.isWithin(x, y, Math.min(least, range))) {
                for (ConvexShape part : mover.parts()) {
                    least = Math.min(least, NearShapes.nearest(cone, part, tangent(mover)));
                }
            }
        }
        return least;
    }
}
