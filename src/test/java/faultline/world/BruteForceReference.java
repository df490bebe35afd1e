package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Segment;
import faultline.geometry.SpecularDistance;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/**
 * Computes by brute force what a world must do in a tick: it tests every shape, without an index or data of the tick
 * before. Only data that depends only on an unchanged obstacle or sensor is cached.
 */
final class BruteForceReference {

    /** The margin with which shapes out of reach are omitted, metres. */
    private static final double MARGIN = 0.01;

    private record ReferenceObstacle(Obstacle obstacle, ObstacleGeometry geometry) {}

    private record Cone(SensorSpec sensor, RigidMotion mount, double cosHalf, double sinHalf) {

        static Cone of(SensorSpec sensor) {
            Vector2 position = sensor.mountPosition();
            return new Cone(
                    sensor,
                    RigidMotion.of(new Pose(position.x(), position.y(), sensor.bearing())),
                    StrictMath.cos(sensor.cone() / 2),
                    StrictMath.sin(sensor.cone() / 2));
        }

        Sector in(RigidMotion robot) {
            return new Sector(robot.after(mount), cosHalf, sinHalf, sensor.range());
        }
    }

    private final World world;
    private final double dt;
    private final List<Segment> sides;
    private final List<Cone> cones = new ArrayList<>();
    private List<ReferenceObstacle> obstacles = List.of();

    BruteForceReference(World world, WorldSpec spec, double dt) {
        this.world = world;
        this.dt = dt;
        double w = spec.width();
        double h = spec.height();
        sides = List.of(
                new Segment(0, 0, w, 0), new Segment(w, 0, w, h), new Segment(w, h, 0, h), new Segment(0, h, 0, 0));
    }

    /** Returns the obstacles as they are now. */
    private List<ReferenceObstacle> obstacles() {
        List<Obstacle> now = world.obstacles();
        List<ReferenceObstacle> references = new ArrayList<>(now.size());
        for (int i = 0; i < now.size(); i++) {
            Obstacle obstacle = now.get(i);
            boolean same = i < obstacles.size() && obstacles.get(i).obstacle() == obstacle;
            references.add(same ? obstacles.get(i) : new ReferenceObstacle(obstacle, ObstacleGeometry.of(obstacle)));
        }
        obstacles = references;
        return references;
    }

    /** Returns the pose after a tick if every static shape is tested for contact. */
    Pose poseAfterTick(double leftVolts, double rightVolts) {
        if (world.collision().isPresent()) {
            return world.pose();
        }
        RobotSpec robot = world.robot();
        WheelSpeeds speeds = robot.motor()
                .step(world.wheelSpeeds(), leftVolts, rightVolts, robot.motor().decay(dt));
        TimeOfImpact impact = new TimeOfImpact(robot.length(), robot.width(), speeds.toVelocity(robot.track()));
        double stop = dt;
        double reach = robot.boundingRadius()
                + Math.abs(speeds.toVelocity(robot.track()).linear()) * dt
                + MARGIN;
        for (Segment side : sides) {
            stop = firstContact(impact, side, reach, stop);
        }
        for (ReferenceObstacle obstacle : obstacles()) {
            if (!obstacle.obstacle().isMoving()) {
                for (ConvexShape part : obstacle.geometry().parts()) {
                    stop = firstContact(impact, part, reach, stop);
                }
            }
        }
        return DifferentialDrive.advance(world.pose(), speeds.toVelocity(robot.track()), stop);
    }

    private double firstContact(TimeOfImpact impact, ConvexShape part, double reach, double stop) {
        Pose pose = world.pose();
        return part.distanceTo(pose.x(), pose.y()) > reach
                ? stop
                : Math.min(stop, impact.firstContactTime(pose, part, Vector2.ZERO, stop));
    }

    /** Returns the true readings of all sensors. */
    double[] readings() {
        List<SensorSpec> sensors = world.robot().sensors();
        List<ReferenceObstacle> references = obstacles();
        RigidMotion frame = RigidMotion.of(world.pose());
        double[] readings = new double[sensors.size()];
        for (int i = 0; i < readings.length; i++) {
            if (cones.size() == i) {
                cones.add(Cone.of(sensors.get(i)));
            } else if (cones.get(i).sensor() != sensors.get(i)) {
                cones.set(i, Cone.of(sensors.get(i)));
            }
            readings[i] = reading(sensors.get(i), cones.get(i).in(frame), references);
        }
        return readings;
    }

    private double reading(SensorSpec sensor, Sector sector, List<ReferenceObstacle> references) {
        Vector2 mount = sensor.mountPosition();
        boolean outside = Math.abs(mount.x()) > world.robot().length() / 2
                || Math.abs(mount.y()) > world.robot().width() / 2;
        if (outside && references.stream().anyMatch(one -> one.geometry().contains(sector.apex()))) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (Segment side : sides) {
            least = Math.min(least, SectorDistance.nearest(sector, side));
        }
        for (ReferenceObstacle one : references) {
            double angle = one.obstacle().specularAngle();
            for (ConvexShape part : one.geometry().parts()) {
                double distance = angle < Obstacle.MATT && part instanceof Segment segment
                        ? SpecularDistance.nearest(new SectorDistance(sector), segment, StrictMath.tan(angle))
                        : SectorDistance.nearest(sector, part);
                least = Math.min(least, distance);
            }
        }
        return least;
    }
}
