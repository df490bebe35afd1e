package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.GainRule;
import faultline.control.RecordedDecision;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.ControllerFactory;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Makes random scenarios with everything in them that a file can hold, and with numbers and names that are hard on
 * writers.
 */
final class RandomScenarios {

    private static final double[] EDGE_VALUES = {
        0.1 + 0.2,
        1.0 / 3,
        1e-6,
        2.2250738585072014E-308,
        1e-300,
        Double.MIN_VALUE,
        5e-5,
        12345.678901234567,
        1e5 - 1e-11
    };
    private static final String[] NAMES = {
        "a", "<&>'", "ø ż 漢", "two words", "x--y", "]]>", "&amp;", "#1;", "😀", " edge "
    };

    private final Random random;

    RandomScenarios(long seed) {
        random = new Random(seed);
    }

    Scenario next() {
        RobotSpec robot = robot();
        List<Obstacle> obstacles = list(random.nextInt(6), i -> obstacle(name() + i, i < 3));
        WorldSpec world = new WorldSpec(size(), size(), false, 3 + random.nextInt(3), obstacles);
        List<TimedCommand> timeline = new ArrayList<>();
        IntStream.range(0, random.nextInt(12)).forEach(i -> timeline.addAll(commands(robot, obstacles)));
        SimulationSetup setup = SimulationSetup.of(
                        world, new Pose(-50_000 - random.nextInt(1000), coordinate(), angle()))
                .withRobot(robot)
                .withController(controller())
                .withTimeline(timeline)
                .withTick(1e-5 + random.nextDouble() / 2)
                .withSeed(random.nextLong())
                .withDuration(edgeValue(0, 1e7));
        return new Scenario(
                name() + "\" \n" + name(), name(), random.nextBoolean(), setup, expectation(setup.controller()));
    }

    private RobotSpec robot() {
        double length = 0.1 + random.nextDouble();
        double width = 0.1 + random.nextDouble();
        List<SensorSpec> sensors =
                new ArrayList<>(random.nextBoolean() ? RobotSpec.standardSensors(length, width) : List.of());
        sensors.replaceAll(sensor -> random.nextInt(4) == 0 ? sensor(sensor.id()) : sensor);
        IntStream.range(0, 1 + random.nextInt(3)).forEach(i -> sensors.add(sensor(name() + i)));
        MotorSpec motor = new MotorSpec(edgeValue(0, 1000), positive(10), positive(100));
        return new RobotSpec(
                length,
                width,
                Math.max(0.1, size()),
                positive(1000),
                Degrees.toRadians(0.001 + 1000 * random.nextDouble()),
                motor,
                new DriveScale(scale(), scale(), scale()),
                sensors);
    }

    private double scale() {
        return 0.5 + random.nextDouble() / 2;
    }

    private SensorSpec sensor(String id) {
        double cone = random.nextInt(10) == 0 ? Math.nextDown(StrictMath.PI) : 1e-9 + 3 * random.nextDouble();
        return new SensorSpec(id, point(), angle(), size(), cone, random.nextBoolean(), edgeValue(0, 100));
    }

    private Obstacle obstacle(String id, boolean mayMove) {
        WaypointPath motion = mayMove && random.nextBoolean() ? motion(points(1)) : WaypointPath.NONE;
        ObstacleShape shape = shape();
        double specular = shape.isFlat() && random.nextBoolean()
                ? Math.nextUp(Obstacle.MATT * random.nextDouble())
                : Obstacle.MATT;
        return new Obstacle(id, shape, new Pose(coordinate(), coordinate(), angle()), motion, specular);
    }

    /** Where the last waypoint leads back to the first, not quicker than a file may have it. */
    private WaypointPath motion(List<Vector2> points) {
        boolean loop = points.get(0).distanceTo(points.get(points.size() - 1)) > 10 && random.nextBoolean();
        return new WaypointPath(edgeValue(0, 1000), loop, points);
    }

    private ObstacleShape shape() {
        return switch (random.nextInt(6)) {
            case 0 -> new ObstacleShape.RectangleShape(extent(), extent());
            case 1 -> new ObstacleShape.CircleShape(extent());
            case 2 -> new ObstacleShape.EllipseShape(extent(), extent());
            case 3 -> new ObstacleShape.PolygonShape(points(3));
            case 4 -> new ObstacleShape.PlanShape(List.of(points(3), points(4)));
            default -> new ObstacleShape.WallShape(points(2));
        };
    }

    private List<TimedCommand> commands(RobotSpec robot, List<Obstacle> obstacles) {
        String sensor =
                robot.sensors().get(random.nextInt(robot.sensors().size())).id();
        double at = edgeValue(0, 1e6);
        return switch (random.nextInt(12)) {
            case 0 -> List.of(new TimedCommand(at, new Command.SwitchSensor(sensor, random.nextBoolean())));
            case 1 -> List.of(new TimedCommand(at, new Command.ConfigureSensor(sensor(sensor))));
            case 2 -> List.of(new TimedCommand(at, new Command.InjectFault(sensor, fault())));
            case 3 -> List.of(new TimedCommand(at, new Command.ClearFault(sensor, fault())));
            case 4 -> List.of(new TimedCommand(at, new Command.ClearFaults(sensor)));
            case 5 -> temporaryFault(sensor, at, fault());
            case 6 -> List.of(new TimedCommand(at, new Command.SetPlatform(size(), size(), positive(1000))));
            case 7 -> List.of(new TimedCommand(at, new Command.PlaceObstacle(obstacle(name(), true))));
            case 8 -> temporaryMotorFault(at, motorFault());
            case 9 -> List.of(new TimedCommand(at, new Command.ClearMotorFaults(MotorSide.LEFT)));
            case 10 -> List.of(new TimedCommand(at, new Command.ConfigureController(builtInController())));
            default ->
                obstacles.isEmpty()
                        ? List.of()
                        : obstacleCommands(
                                at,
                                obstacles.get(random.nextInt(obstacles.size())).id());
        };
    }

    /**
     * A fault and its repair, side by side; sometimes the repair is not later, so that it must not be joined to the
     * fault.
     */
    private List<TimedCommand> temporaryFault(String sensor, double at, Fault fault) {
        double until = random.nextInt(3) == 0 ? at : at + random.nextDouble();
        return List.of(
                new TimedCommand(at, new Command.InjectFault(sensor, fault)),
                new TimedCommand(until, new Command.ClearFault(sensor, fault)));
    }

    private List<TimedCommand> temporaryMotorFault(double at, MotorFault fault) {
        double until = random.nextInt(3) == 0 ? at : at + random.nextDouble();
        return List.of(
                new TimedCommand(at, new Command.InjectMotorFault(MotorSide.RIGHT, fault)),
                new TimedCommand(until, new Command.ClearMotorFault(MotorSide.RIGHT, fault)));
    }

    private MotorFault motorFault() {
        MotorFaultKind kind = MotorFaultKind.values()[random.nextInt(MotorFaultKind.values().length)];
        return kind.createFault(kind.minValue() + (kind.maxValue() - kind.minValue()) * random.nextDouble());
    }

    private List<TimedCommand> obstacleCommands(double at, String id) {
        Command command = random.nextBoolean()
                ? new Command.RemoveObstacle(id)
                : new Command.MoveObstacle(id, new Pose(coordinate(), coordinate(), angle()));
        return List.of(new TimedCommand(at, command));
    }

    private Fault fault() {
        FaultKind kind = FaultKind.values()[random.nextInt(FaultKind.values().length)];
        return kind.createFault(kind.minValue() + (kind.maxValue() - kind.minValue()) * random.nextDouble());
    }

    private ControllerSpec controller() {
        return switch (random.nextInt(4)) {
            case 0 -> new ControllerSpec.Extern(edgeValue(0, 10));
            case 1 -> new ControllerSpec.Recorded(size(), 1000, decisions());
            default -> builtInController();
        };
    }

    private ControllerSpec.BuiltIn builtInController() {
        return switch (random.nextInt(3)) {
            case 0 -> new ControllerSpec.None();
            case 1 -> new ControllerSpec.Drive(edgeValue(-1e4, 1e4), edgeValue(-1e4, 1e4));
            default ->
                new ControllerSpec.WallFollowing(
                        size(),
                        random.nextBoolean() ? WallSide.LEFT : WallSide.RIGHT,
                        edgeValue(0, 10),
                        random.nextBoolean() ? TimingRule.EQUAL_READINGS : TimingRule.RANGE,
                        random.nextBoolean(),
                        gainRule(),
                        thresholds());
        };
    }

    private Thresholds thresholds() {
        Thresholds result = Thresholds.DEFAULT;
        for (Threshold threshold : Threshold.values()) {
            Threshold.Quantity quantity = threshold.quantity();
            result = random.nextBoolean() ? result.with(threshold, edgeValue(quantity.min(), quantity.max())) : result;
        }
        return result;
    }

    private GainRule gainRule() {
        return switch (random.nextInt(3)) {
            case 0 -> GainRule.AUTOMATIC;
            case 1 -> new GainRule.Length(size());
            default -> new GainRule.Fixed(positive(1e6), positive(1e6));
        };
    }

    private List<RecordedDecision> decisions() {
        List<RecordedDecision> decisions = new ArrayList<>();
        for (long tick = random.nextInt(3); tick < 1000; tick += 1 + random.nextInt(200)) {
            decisions.add(new RecordedDecision(
                    tick, edgeValue(-1e300, 1e300), random.nextGaussian(), "S" + random.nextInt(2), name()));
        }
        return decisions;
    }

    private Expectation expectation(ControllerSpec controller) {
        ControllerState first = ControllerFactory.initialState(controller);
        return new Expectation(Stream.<Expectation.Condition>of(
                        new Expectation.Collides(random.nextBoolean()),
                        new Expectation.MinCoverage(random.nextDouble()),
                        new Expectation.MaxDistanceRms(size()),
                        new Expectation.VisitedState(first),
                        new Expectation.FinalState(first))
                .filter(condition -> random.nextBoolean())
                .toList());
    }

    private List<Vector2> points(int least) {
        return list(least + random.nextInt(4), i -> point());
    }

    private <T> List<T> list(int size, IntFunction<T> maker) {
        return IntStream.range(0, size).mapToObj(maker).toList();
    }

    private Vector2 point() {
        return new Vector2(coordinate(), coordinate());
    }

    private double size() {
        return edgeValue(1e-6, 1e5);
    }

    /** Of an obstacle: too small to reach the robot. */
    private double extent() {
        return edgeValue(1e-6, 1000);
    }

    private double positive(double most) {
        return edgeValue(Double.MIN_VALUE, most);
    }

    /** Never far to the left, where the robot starts. */
    private double coordinate() {
        return random.nextInt(8) == 0 ? -0.0 : edgeValue(-100, 1000);
    }

    private double angle() {
        return switch (random.nextInt(6)) {
            case 0 -> -0.0;
            case 1 -> StrictMath.PI;
            case 2 -> Degrees.toRadians(random.nextInt(720) - 360);
            default -> random.nextGaussian() * 10;
        };
    }

    /** An awkward number, or any, or a round one, within bounds. */
    private double edgeValue(double least, double most) {
        double value =
                switch (random.nextInt(3)) {
                    case 0 -> EDGE_VALUES[random.nextInt(EDGE_VALUES.length)];
                    case 1 -> least + (most - least) * random.nextDouble();
                    default -> random.nextInt(1000) / 100.0;
                };
        return Math.max(least, Math.min(most, value));
    }

    private String name() {
        return NAMES[random.nextInt(NAMES.length)];
    }
}
