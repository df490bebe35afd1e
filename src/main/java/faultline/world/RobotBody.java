package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Segment;
import faultline.geometry.Separation;
import faultline.geometry.StrictTrig;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.ArrayList;
import java.util.List;

/**
 * The robot's body in motion; mutable, confined to the simulation thread. Pose and speeds are kept as numbers, so that
 * a tick allocates nothing.
 */
final class RobotBody {

    /** The tolerance of contact points, metres: ten times that at which {@link TimeOfImpact} ends. */
    private static final double CONTACT_TOLERANCE = 1e-9;

    private RobotSpec spec;
    private double x;
    private double y;
    private double heading;
    private double cos = 1;
    private double sin;
    private double leftSpeed;
    private double rightSpeed;

    /** Half the turn of the last motion, and the length of its chord in relation to the arc's. */
    private double lastHalf;

    private double chordPerArc = DifferentialDrive.chordPerArc(0);

    private MotorFaults motorFaults = MotorFaults.NONE;
    private MotorSpec leftMotor;
    private MotorSpec rightMotor;
    private double trueTrack;
    private double boundingRadius;

    RobotBody(RobotSpec spec, Pose pose) {
        setSpec(spec);
        x = pose.x();
        y = pose.y();
        setHeading(pose.heading());
    }

    private void setHeading(double newHeading) {
        // The sign of a zero may have changed.
        if (newHeading != heading || newHeading == 0) {
            cos = StrictTrig.cos(newHeading);
            sin = StrictTrig.sin(newHeading);
        }
        heading = newHeading;
    }

    RobotSpec spec() {
        return spec;
    }

    void setSpec(RobotSpec newSpec) {
        spec = newSpec;
        leftMotor = newSpec.motor().scaled(newSpec.driveScale().left());
        rightMotor = newSpec.motor().scaled(newSpec.driveScale().right());
        trueTrack = newSpec.trueTrack();
        boundingRadius = newSpec.boundingRadius();
    }

    MotorFaults motorFaults() {
        return motorFaults;
    }

    void setMotorFaults(MotorFaults faults) {
        motorFaults = faults;
    }

    Pose pose() {
        return new Pose(x, y, heading);
    }

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    double heading() {
        return heading;
    }

    double cos() {
        return cos;
    }

    double sin() {
        return sin;
    }

    RigidMotion frame() {
        return new RigidMotion(cos, sin, x, y);
    }

    WheelSpeeds wheelSpeeds() {
        return new WheelSpeeds(leftSpeed, rightSpeed);
    }

    Velocity velocity() {
        return new Velocity(v(), omega());
    }

    /** Returns the linear velocity, metres per second. */
    double v() {
        return (rightSpeed + leftSpeed) / 2;
    }

    /** Returns the angular velocity, radians per second. */
    double omega() {
        return (rightSpeed - leftSpeed) / trueTrack;
    }

    /** Returns the radius of the circle about the centre that encloses the platform, metres. */
    double boundingRadius() {
        return boundingRadius;
    }

    boolean isAtRest() {
        return leftSpeed == 0 && rightSpeed == 0;
    }

    /** Applies the motors' voltages; the new wheel speeds hold for the whole tick. */
    void driveMotors(double leftVolts, double rightVolts, double decay) {
        leftSpeed = leftMotor.step(leftSpeed, effectiveVolts(MotorSide.LEFT, leftMotor, leftVolts), decay);
        rightSpeed = rightMotor.step(rightSpeed, effectiveVolts(MotorSide.RIGHT, rightMotor, rightVolts), decay);
    }

    /** Returns the voltage that has an effect after the faults; the motor limits it again. */
    private double effectiveVolts(MotorSide side, MotorSpec motor, double volts) {
        return motorFaults == MotorFaults.NONE ? volts : motorFaults.apply(side, motor.limit(volts));
    }

    /** Moves for some seconds at the current wheel speeds, as {@link DifferentialDrive#advance} does. */
    void advance(double time) {
        double turn = omega() * time;
        double half = turn / 2;
        if (half != lastHalf) {
            lastHalf = half;
            chordPerArc = DifferentialDrive.chordPerArc(half);
        }
        double chord = v() * time * chordPerArc;
        double direction = heading + half;
        x += chord * StrictTrig.cos(direction);
        y += chord * StrictTrig.sin(direction);
        setHeading(heading + turn);
    }

    /** Stops at once. */
    void stop() {
        leftSpeed = 0;
        rightSpeed = 0;
    }

    OrientedBox box() {
        return new OrientedBox(frame(), spec.length() / 2, spec.width() / 2);
    }

    /** Returns the radius about the centre within which the body stays for some seconds, metres. */
    double reachableRadius(double time) {
        return boundingRadius + Math.abs(v()) * time;
    }

    TimeOfImpact timeOfImpact() {
        return new TimeOfImpact(spec.length(), spec.width(), velocity());
    }

    /** Returns where the body touches a shape: the ends of the contact if a side lies flush, else one point. */
    List<Vector2> contactPoints(ConvexShape shape) {
        OrientedBox box = box();
        List<Vector2> points = new ArrayList<>();
        Separation gap = BoxDistance.between(box, shape);
        if (gap.distance() > CONTACT_TOLERANCE) {
            return points;
        }
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            Vector2 corner = box.corner(i);
            addIfTouching(points, shape.nearestTo(corner), corner);
        }
        if (shape instanceof Segment segment) {
            addIfTouching(points, segment.a(), box.nearestTo(segment.a()));
            addIfTouching(points, segment.b(), box.nearestTo(segment.b()));
        }
        if (points.isEmpty()) {
            points.add(gap.onShape());
        }
        return points;
    }

    /** Returns the middle of contact points on one side of the body; of points on several sides, the first. */
    Vector2 middleOf(List<Vector2> contacts) {
        Vector2 middle = contacts.stream().reduce(Vector2.ZERO, Vector2::plus).times(1.0 / contacts.size());
        OrientedBox box = box();
        Vector2 local = box.frame().toLocal(middle);
        boolean isInside = Math.abs(local.x()) < box.halfLength() - 2 * CONTACT_TOLERANCE
                && Math.abs(local.y()) < box.halfWidth() - 2 * CONTACT_TOLERANCE;
        return isInside ? contacts.get(0) : middle;
    }

    private static void addIfTouching(List<Vector2> points, Vector2 onShape, Vector2 onBox) {
        boolean touching = onShape.distanceTo(onBox) <= CONTACT_TOLERANCE;
        if (touching && points.stream().noneMatch(point -> point.distanceTo(onShape) <= 2 * CONTACT_TOLERANCE)) {
            points.add(onShape);
        }
    }
}
