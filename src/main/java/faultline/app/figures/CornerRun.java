package faultline.app.figures;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.Setup;
import faultline.geometry.Degrees;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Set;

/** A run along one wall into an inner corner and along the other, with only some sensors switched on. */
final class CornerRun {

    static final Set<String> TWO = Set.of("left", "front");
    static final Set<String> THREE = Set.of("left", "front", "front-right");

    static final Set<String> FOUR = Set.of("left", "front", "front-right", "front-left");

    private static final Setup BASE = Shipped.load("studies/corner.xml").setup();

    private CornerRun() {
    }

    static Journey of(double degrees, Set<String> sensors) {
        RobotSpec robot = BASE.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(sensor.withOn(sensors.contains(sensor.id())));
        }
        return Journey.of(Variation.of(Walls.corner(BASE, Degrees.toRadians(degrees), WallFollowing.DEFAULT.distance(), 0), robot));
    }

    /**
     * How far the second wall is from the wanted distance when the robot has been aligned with it, millimetres; not a number where it was
     * not.
     */
    static double error(Journey journey) {
        List<Integer> handOvers = journey.handOvers();
        return handOvers.size() < 2 ? Double.NaN : 1000 * (journey.distances().get(handOvers.get(1)) - WallFollowing.DEFAULT.distance());
    }
}
