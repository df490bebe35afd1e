package faultline.control.wallfollower;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.PeriodicController;
import faultline.control.Telemetry;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.robot.DifferentialDrive;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/**
 * A robot under a follower in the lower half plane, above which one wall runs for ever along the x axis; its readings
 * are written down in closed form.
 */
public final class StraightWallFixture {

    private final RobotSpec robot;
    private final Controller controller;
    private final List<ControllerState> states = new ArrayList<>();
    private Pose pose;
    private double left;
    private double right;
    private long tick;
    private Telemetry telemetry = Telemetry.ofState(ControllerState.of(""));

    /** Starts below the wall at a distance of the centre, heading towards it at an angle, degrees. */
    public StraightWallFixture(
            RobotSpec robot, ControllerSpec.WallFollowing spec, double distance, double headingDegrees) {
        this.robot = robot;
        this.controller = new PeriodicController(new WallFollower(spec), spec.period());
        this.pose = new Pose(0, -distance, Math.toRadians(headingDegrees));
    }

    /** Runs until the follower is in a state, for a minute at most. */
    public StraightWallFixture runUntil(FollowerState state) {
        for (long end = tick + 6000; tick < end && telemetry.state() != state; ) {
            tick();
        }
        return this;
    }

    private void tick() {
        double[] readings = robot.sensors().stream().mapToDouble(this::reading).toArray();
        Decision decision = controller.decide(new Observation(tick, Observations.DT, robot, readings));
        telemetry = decision.telemetry();
        if (states.isEmpty() || !states.get(states.size() - 1).equals(telemetry.state())) {
            states.add(telemetry.state());
        }
        drive(decision);
        tick++;
    }

    private void drive(Decision decision) {
        MotorSpec motor = robot.motor();
        double decay = motor.decay(Observations.DT);
        left = motor.step(left, decision.leftVolts(), decay);
        right = motor.step(right, decision.rightVolts(), decay);
        pose = DifferentialDrive.advance(pose, new WheelSpeeds(left, right).toVelocity(robot.track()), Observations.DT);
    }

    /**
     * Returns the foot of the perpendicular if it lies in the cone, otherwise the point of the wall on the nearest edge
     * of the cone.
     */
    private double reading(SensorSpec sensor) {
        double away = -pose.toParent(sensor.mountPosition()).y();
        double off = Math.abs(Angles.difference(Math.PI / 2, pose.heading() + sensor.bearing()));
        double slant = Math.max(0, off - sensor.cone() / 2);
        double reading = slant < Math.PI / 2 ? away / Math.cos(slant) : Reading.NOTHING;
        return reading <= sensor.range() ? reading : Reading.NOTHING;
    }

    /** The heading relative to the direction of the wall, degrees. */
    double headingDegrees() {
        return Math.toDegrees(Angles.normalize(pose.heading()));
    }

    /** The distance of the robot's centre from the wall, metres. */
    double distance() {
        return -pose.y();
    }

    /** The states passed so far. */
    public List<ControllerState> states() {
        return states;
    }

    public Telemetry telemetry() {
        return telemetry;
    }
}
