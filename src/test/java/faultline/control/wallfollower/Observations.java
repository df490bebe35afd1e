package faultline.control.wallfollower;

import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
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

    /**
     * What the follower's left and front sensors see in one look, for a robot that has rolled and turned as commanded
     * for a tick.
     */
    static StateEstimate stateEstimate(double left) {
        StateEstimate perception = new StateEstimate(ControllerSpec.WallFollowing.DEFAULT);
        perception.update(observation(0, Map.of("left", left)));
        return perception;
    }
}
