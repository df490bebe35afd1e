package faultline.control.wallfollower;

import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.control.Odometer;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.Map;

/** Observations at will, in ticks of 10 ms, of a robot whose named sensors see something and the others nothing. */
public final class Observations {

    public static final double DT = 0.01;

    /** The standard robot with motors that follow at once: 0.3 m/s, 60 degrees per second. */
    static final RobotSpec LAG_FREE_ROBOT = new RobotSpec(
            0.25,
            0.20,
            0.18,
            0.3,
            RobotSpec.DEFAULT.turnRate(),
            new MotorSpec(0, 0.1, 6),
            DriveScale.NONE,
            RobotSpec.DEFAULT.sensors());

    private Observations() {}

    public static Observation observation(long tick, Map<String, Double> readings) {
        return observation(tick, LAG_FREE_ROBOT, readings);
    }

    static Observation observation(long tick, RobotSpec robot, Map<String, Double> readings) {
        double[] all = new double[robot.sensors().size()];
        Arrays.fill(all, Reading.NOTHING);
        readings.forEach((id, reading) -> all[robot.indexOf(id)] = reading);
        return new Observation(tick, DT, robot, all);
    }

    /** Returns what the follower's left and front sensors see at first, for a robot at rest. */
    static StateEstimate stateEstimate(double left) {
        StateEstimate perception = new StateEstimate(ControllerSpec.WallFollowing.DEFAULT, new Odometer());
        perception.update(observation(0, Map.of("left", left)));
        return perception;
    }

    /** Lets the odometer of an estimate see a tick at a commanded velocity. */
    static void drive(StateEstimate perception, Velocity velocity) {
        WheelSpeeds wheels = WheelSpeeds.of(velocity, LAG_FREE_ROBOT.track());
        MotorSpec motor = LAG_FREE_ROBOT.motor();
        perception
                .odometer()
                .advance(LAG_FREE_ROBOT, motor.voltageFor(wheels.left()), motor.voltageFor(wheels.right()), DT, 1);
    }
}
