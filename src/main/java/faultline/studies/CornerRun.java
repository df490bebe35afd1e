package faultline.studies;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.robot.RobotSpec;
import faultline.studies.figure.SortedSample;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.IntStream;

/** A run along one wall into an inner corner and along the other, with only some sensors switched on. */
final class CornerRun {

    /** The sensors that are on: left and front, and additional ones. */
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
        return RunTrace.simulate(setup(degrees, sensors, 0));
    }

    /** Returns a setup with one of several starts; number 0 is that of the figure. */
    private static SimulationSetup setup(double degrees, SensorSelection sensors, int start) {
        RobotSpec robot =
                SetupVariations.withSensors(BASE.robot(), sensor -> sensor.withOn(sensors.includes(sensor.id())));
        return WallScenes.corner(BASE, Degrees.toRadians(degrees), WallFollowing.DEFAULT.distance(), start)
                .withRobot(robot);
    }

    /** Returns the distance error after the corner of a run from one of several starts, millimetres. */
    static OptionalDouble distanceError(double degrees, SensorSelection sensors, int start) {
        return new AlignmentTrial(setup(degrees, sensors, start), 2)
                .run()
                .map(result -> OptionalDouble.of(1000 * (result.distance() - WallFollowing.DEFAULT.distance())))
                .orElse(OptionalDouble.empty());
    }

    /** Returns the distance errors of runs from several starts, millimetres. */
    static SortedSample distanceErrors(double degrees, SensorSelection sensors, int starts) {
        return SortedSample.of(IntStream.range(0, starts)
                .mapToObj(start -> distanceError(degrees, sensors, start))
                .flatMapToDouble(OptionalDouble::stream));
    }
}
