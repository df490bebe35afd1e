package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Separation;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.ArrayList;
import java.util.List;

/** The robot as it stands and rolls; mutable, on the world's thread. */
final class RobotBody {

    /** Points of a contact are looked for within this distance, metres: ten times the touching gap. */
    private static final double CONTACT_TOLERANCE = 1e-9;

    private RobotSpec spec;
    private Pose pose;
    private WheelSpeeds wheelSpeeds = WheelSpeeds.ZERO;

    RobotBody(RobotSpec spec, Pose pose) {
        this.spec = spec;
        this.pose = pose;
    }

    RobotSpec spec() {
        return spec;
    }

    void setSpec(RobotSpec newSpec) {
        spec = newSpec;
    }

    Pose pose() {
        return pose;
    }

    WheelSpeeds wheelSpeeds() {
        return wheelSpeeds;
    }

    Velocity velocity() {
        return wheelSpeeds.toVelocity(spec.track());
    }

    /** Voltage to wheel speed, once a tick: the new speeds hold for the whole tick. */
    void driveMotors(double leftVolts, double rightVolts, double decay) {
        wheelSpeeds = spec.motor().step(wheelSpeeds, leftVolts, rightVolts, decay);
    }

    /** Rolls on at the present wheel speeds. */
    void advance(double time) {
        pose = DifferentialDrive.advance(pose, velocity(), time);
    }

    /** Stands still, at once and for good. */
    void stop() {
        wheelSpeeds = WheelSpeeds.ZERO;
    }

    OrientedBox box() {
        return new OrientedBox(pose, spec.length(), spec.width());
    }

    /** How far any point of the body can come from its centre's present place in a time, metres. */
    double reachableRadius(double time) {
        return spec.boundingRadius() + Math.abs(velocity().linear()) * time;
    }

    /** A sweep of the body at its present wheel speeds. */
    TimeOfImpact timeOfImpact() {
        return new TimeOfImpact(spec.length(), spec.width(), velocity());
    }

    /** Where the body touches a figure: the ends of the common piece if a side lies flush, else one point. */
    List<Vector2> contactPoints(ConvexShape figure) {
        OrientedBox box = box();
        List<Vector2> points = new ArrayList<>();
        Separation gap = BoxDistance.between(box, figure);
        if (gap.distance() > CONTACT_TOLERANCE) {
            return points;
        }
        for (int i = 0; i < 4; i++) {
            Vector2 corner = box.corner(i);
            addIfNew(points, figure.nearestTo(corner), corner);
        }
        if (figure instanceof Segment segment) {
            addIfNew(points, segment.a(), box.nearestTo(segment.a()));
            addIfNew(points, segment.b(), box.nearestTo(segment.b()));
        }
        if (points.isEmpty()) {
            points.add(gap.onShape());
        }
        return points;
    }

    private static void addIfNew(List<Vector2> points, Vector2 onFigure, Vector2 onBox) {
        boolean touching = onFigure.distanceTo(onBox) <= CONTACT_TOLERANCE;
        if (touching && points.stream().noneMatch(point -> point.distanceTo(onFigure) <= 2 * CONTACT_TOLERANCE)) {
            points.add(onFigure);
        }
    }
}
