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

    /** Which sensors are on: left and front, and what is added. */
    enum Sensors {
        TWO("left and front"), FRONT_RIGHT("with front-right", "front-right"), FRONT_LEFT("with front-left", "front-left"),
        FOUR("with both", "front-right", "front-left");

        private final String title;
        private final Set<String> more;

        Sensors(String title, String... more) {
            this.title = title;
            this.more = Set.of(more);
        }

        String title() {
            return title;
        }

        String fileName() {
            return title.replace(' ', '-');
        }

        boolean include(String id) {
            return id.equals("left") || id.equals("front") || more.contains(id);
        }
    }

    private static final Setup BASE = Shipped.load("studies/corner.xml").setup();

    private CornerRun() {
    }

    static Journey of(double degrees, Sensors sensors) {
        RobotSpec robot = BASE.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(sensor.withOn(sensors.include(sensor.id())));
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
