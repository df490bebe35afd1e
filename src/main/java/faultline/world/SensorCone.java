package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;
import java.util.List;

/**
 * A sensor's cone that moves with the robot, and the static shapes that it may see while the robot stays near a pose.
 * Confined to the world's thread.
 */
final class SensorCone {

    /** From this half angle, radians, all shapes around the sensor are kept. */
    private static final double MAX_WEDGE = 1.4;

    private static final double MARGIN = 1e-9;

    private final NearShapes near = new NearShapes();
    private final double range;
    private final double cosHalf;
    private final double sinHalf;
    private final double specularTangent;
    private final RigidMotion mount;
    private final SectorDistance cone;

    // A wider cone, set back, that contains all cones of this sensor while the robot stays near a pose.
    private final double travel;
    private final boolean narrow;
    private final double setback;
    private final SectorDistance wedge;

    /**
     * Creates a cone.
     *
     * @param spec the sensor
     * @param specularAngle the greatest angle of incidence at which any flat surface is sensed, radians
     * @param maxTravel how far the robot moves before {@link #collect} is called again, metres
     * @param maxTurn how far it turns before that, radians
     */
    SensorCone(SensorSpec spec, double specularAngle, double maxTravel, double maxTurn) {
        Vector2 position = spec.mountPosition();
        range = spec.range();
        cosHalf = StrictMath.cos(spec.cone() / 2);
        sinHalf = StrictMath.sin(spec.cone() / 2);
        specularTangent = ShapeOwner.tangent(specularAngle);
        mount = RigidMotion.of(new Pose(position.x(), position.y(), spec.bearing()));
        cone = new SectorDistance(sector(RigidMotion.IDENTITY));
        travel = maxTravel + maxTurn * position.length() + MARGIN;
        double half = spec.cone() / 2 + maxTurn + MARGIN;
        narrow = half < MAX_WEDGE;
        setback = narrow ? travel / StrictMath.sin(half) : 0;
        wedge = narrow ? new SectorDistance(Sector.of(Vector2.ZERO, 0, 2 * half, range + travel + setback)) : cone;
    }

    /** Returns the cone in the world. */
    Sector sector(RigidMotion robot) {
        return new Sector(robot.after(mount), cosHalf, sinHalf, range);
    }

    double apexX(RobotBody body) {
        return body.x() + body.cos() * mount.x() - body.sin() * mount.y();
    }

    double apexY(RobotBody body) {
        return body.y() + body.sin() * mount.x() + body.cos() * mount.y();
    }

    /** Collects the candidates that this sensor may see while the robot stays near its present pose. */
    void collect(CandidateBuffer candidates, RobotBody body) {
        near.clear();
        double x = apexX(body);
        double y = apexY(body);
        if (narrow) {
            double ux = body.cos() * mount.cos() - body.sin() * mount.sin();
            double uy = body.sin() * mount.cos() + body.cos() * mount.sin();
            wedge.moveTo(x - setback * ux, y - setback * uy, ux, uy);
        }
        for (int i = 0; i < candidates.size(); i++) {
            ConvexShape shape = candidates.shape(i);
            double distance = shape.distanceTo(x, y);
            if (distance <= range + travel && (!narrow || wedge.nearest(shape) < Double.POSITIVE_INFINITY)) {
                near.add(shape, tangent(candidates.owner(i)), distance - travel - MARGIN);
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
     * @param moving moving obstacles near the robot
     */
    double measure(RobotBody body, List<MovingObstacle> moving) {
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
        double least = near.nearest(cone);
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
