package faultline.studies;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Set;

/** A run along one wall into an inner corner and along the other, with only some sensors switched on. */
final class CornerRun {

    /** Which sensors are on: left and front, and what is added. */
    enum SensorSelection {
        TWO("left and front"),
        FRONT_RIGHT("with front-right", "front-right"),
        FRONT_LEFT("with front-left", "front-left"),
        FOUR("with both", "front-right", "front-left");

        private final String title;
        private final Set<String> additional;

        SensorSelection(String title, String... more) {
            this.title = title;
            this.additional = Set.of(more);
        }

        String title() {
            return title;
        }

        String fileName() {
            return title.replace(' ', '-');
        }

        boolean includes(String id) {
            return id.equals("left") || id.equals("front") || additional.contains(id);
        }
    }

    private static final SimulationSetup BASE =
            StudyScenarios.load("studies/corner.xml").setup();

    private CornerRun() {}

    static RunTrace run(double degrees, SensorSelection sensors) {
        RobotSpec robot = BASE.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(sensor.withOn(sensors.includes(sensor.id())));
        }
        return RunTrace.simulate(
                WallScenes.corner(BASE, Degrees.toRadians(degrees), WallFollowing.DEFAULT.distance(), 0)
                        .withRobot(robot));
    }

    /**
     * How far the second wall is from the wanted distance when the robot has been aligned with it, millimetres; not a
     * number where it was not.
     */
    static double distanceError(RunTrace journey) {
        List<Integer> handOvers = journey.handOvers();
        return handOvers.size() < 2
                ? Double.NaN
                : 1000 * (journey.distances().get(handOvers.get(1)) - WallFollowing.DEFAULT.distance());
    }
}
