package faultline.studies;

import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The study of eq. (4), t_p = t_D / 2: the varied quantities and their values. */
final class EquationFour {

    private static final SimulationSetup CORNER =
            StudyScenarios.load("studies/eq4-corner.xml").setup();
    private static final double RANGE = 0.8;
    private static final double CONE = Degrees.toRadians(20);
    private static final double RATE = Degrees.toRadians(60);
    private static final double TAU = 0.05;
    private static final int TRIALS = 6;

    private EquationFour() {}

    static List<ParameterSweep> sweeps() {
        return Stream.of(rangeSweeps(), timeSweeps(), mountingSweeps(), wallSweeps())
                .flatMap(List::stream)
                .toList();
    }

    private static List<ParameterSweep> rangeSweeps() {
        return List.of(
                sweep(
                        "distance",
                        "Wanted distance to the wall",
                        "distance (m)",
                        steps(0.08, 0.04, 19),
                        (value, trial, variant) -> trial.withDistance(value)
                                .withSetup(WallScenes.endless(AlignmentTrial.BASE, value, variant))),
                sweep(
                        "range",
                        "Range of the sensor",
                        "range (m)",
                        steps(0.3, 0.1, 13),
                        (value, trial, variant) -> trial.withRobot(AlignmentTrial.robot(value, CONE, RATE, TAU))),
                sweep(
                        "cone",
                        "Cone of the sensor",
                        "full cone angle (degrees)",
                        steps(2, 4, 15),
                        (value, trial, variant) ->
                                trial.withRobot(AlignmentTrial.robot(RANGE, Degrees.toRadians(value), RATE, TAU))));
    }

    private static List<ParameterSweep> timeSweeps() {
        return List.of(
                sweep(
                        "spin-rate",
                        "Spin rate",
                        "spin rate (degrees/s)",
                        steps(15, 15, 10),
                        (value, trial, variant) ->
                                trial.withRobot(AlignmentTrial.robot(RANGE, CONE, Degrees.toRadians(value), TAU))),
                sweep(
                        "period",
                        "Control period",
                        "control period (ms)",
                        steps(2, 6, 14),
                        (value, trial, variant) -> trial.withPeriod(value / 1000)),
                sweep(
                        "motor",
                        "Time constant of the motors",
                        "time constant (ms)",
                        steps(0, 20, 11),
                        (value, trial, variant) ->
                                trial.withRobot(AlignmentTrial.robot(RANGE, CONE, RATE, value / 1000))));
    }

    private static List<ParameterSweep> mountingSweeps() {
        return List.of(
                sweep(
                        "position-along",
                        "Mounting position along the axis of the sensor",
                        "mounting position left of the centre (mm)",
                        steps(0, 10, 11),
                        (value, trial, variant) -> trial.withRobot(withMountPosition(0, value / 1000))),
                sweep(
                        "position-ahead",
                        "Axis that misses the centre",
                        "mounting position ahead of the centre (mm)",
                        steps(-60, 10, 13),
                        (value, trial, variant) -> trial.withRobot(withMountPosition(value / 1000, 0.1))),
                sweep(
                        "noise",
                        "Noise of the sensors",
                        "standard deviation of the noise (mm)",
                        steps(0, 1, 13),
                        (value, trial, variant) -> trial.withRobot(withNoise(value / 1000))));
    }

    private static List<ParameterSweep> wallSweeps() {
        return List.of(
                sweep(
                        "wall-length",
                        "Wall that ends ahead",
                        "wall ahead of the robot (m)",
                        steps(0.12, 0.06, 16),
                        (value, trial, variant) ->
                                trial.withSetup(WallScenes.ending(AlignmentTrial.BASE, value, 0.25, variant))),
                sweep(
                        "corner",
                        "Inner corner",
                        "angle between the walls (degrees)",
                        steps(40, 5, 22),
                        (value, trial, variant) -> trial.withSetup(
                                        WallScenes.corner(CORNER, Degrees.toRadians(value), 0.25, variant))
                                .withHandOver(2)),
                sweep(
                        "corner-short-range",
                        "Inner corner, sensors of 0.3 m",
                        "angle between the walls (degrees)",
                        steps(40, 5, 22),
                        (value, trial, variant) -> trial.withRobot(AlignmentTrial.robot(0.3, CONE, RATE, TAU))
                                .withSetup(WallScenes.corner(CORNER, Degrees.toRadians(value), 0.25, variant))
                                .withHandOver(2)));
    }

    private static ParameterSweep sweep(
            String name, String title, String label, List<Double> values, ParameterSweep.TrialFactory trials) {
        return new ParameterSweep("eq4-" + name, title, label, values, name.startsWith("corner") ? 2 : TRIALS, trials);
    }

    private static List<Double> steps(double from, double step, int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> Math.round((from + i * step) * 1000) / 1000.0)
                .toList();
    }

    private static RobotSpec withMountPosition(double ahead, double aside) {
        RobotSpec robot = AlignmentTrial.robot(RANGE, CONE, RATE, TAU);
        SensorSpec left = robot.sensor("left").orElseThrow();
        return robot.withSensor(
                left.withMountPosition(new Vector2(ahead, aside)).withOn(true).withNoise(0));
    }

    private static RobotSpec withNoise(double deviation) {
        return SetupVariations.withSensors(AlignmentTrial.robot(RANGE, CONE, RATE, TAU), sensor -> sensor.withOn(true)
                .withNoise(deviation));
    }
}
