package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.Hand;
import faultline.control.Timing;
import faultline.engine.Setup;
import faultline.engine.Setup.Timed;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Makes random scenarios with everything in them that a file can hold, and with numbers and names that are hard on writers. */
final class RandomScenarios {

    private static final double[] AWKWARD = {0.1 + 0.2, 1.0 / 3, 1e-6, 2.2250738585072014E-308, 1e-300, Double.MIN_VALUE, 5e-5,
            12345.678901234567, 1e5 - 1e-11};
    private static final String[] NAMES = {"a", "<&>'", "ø ż 漢", "two words", "x--y", "]]>", "&amp;", "#1;", "😀", " edge "};

    private final Random random;

    RandomScenarios(long seed) {
        random = new Random(seed);
    }

    Scenario next() {
        RobotSpec robot = robot();
        List<Obstacle> obstacles = list(random.nextInt(6), i -> obstacle(name() + i, i < 3));
        WorldSpec world = new WorldSpec(size(), size(), false, 3 + random.nextInt(3), obstacles);
        List<Timed> timeline = new ArrayList<>();
        IntStream.range(0, random.nextInt(12)).forEach(i -> timeline.addAll(event(robot, obstacles)));
        Setup setup = new Setup(world, robot, new Pose(-50_000 - random.nextInt(1000), coordinate(), angle()), controller(), timeline,
                1e-5 + random.nextDouble() / 2, random.nextLong(), awkward(0, 1e7));
        return new Scenario(name() + "\" \n" + name(), name(), random.nextBoolean(), setup, expectation(setup.controller()));
    }

    private RobotSpec robot() {
        double length = 0.1 + random.nextDouble();
        double width = 0.1 + random.nextDouble();
        List<SensorSpec> sensors = new ArrayList<>(random.nextBoolean() ? RobotSpec.standardSensors(length, width) : List.of());
        sensors.replaceAll(sensor -> random.nextInt(4) == 0 ? sensor(sensor.id()) : sensor);
        IntStream.range(0, 1 + random.nextInt(3)).forEach(i -> sensors.add(sensor(name() + i)));
        MotorSpec motor = new MotorSpec(awkward(0, 1000), positive(10), positive(100));
        return new RobotSpec(length, width, Math.max(0.1, size()), positive(1000), Degrees.toRadians(0.001 + 1000 * random.nextDouble()),
                motor, sensors);
    }

    private SensorSpec sensor(String id) {
        double cone = random.nextInt(10) == 0 ? Math.nextDown(StrictMath.PI) : 1e-9 + 3 * random.nextDouble();
        return new SensorSpec(id, point(), angle(), size(), cone, random.nextBoolean(), awkward(0, 100));
    }

    private Obstacle obstacle(String id, boolean mayMove) {
        Optional<Motion> motion = mayMove && random.nextBoolean()
                ? Optional.of(motion(points(1))) : Optional.empty();
        ObstacleShape shape = shape();
        boolean flat = !(shape instanceof ObstacleShape.Circle || shape instanceof ObstacleShape.Ellipse);
        double specular = flat && random.nextBoolean() ? Math.nextUp(Obstacle.MATT * random.nextDouble()) : Obstacle.MATT;
        return new Obstacle(id, shape, new Pose(coordinate(), coordinate(), angle()), motion, specular);
    }

    /** Where the last way-point leads back to the first, not quicker than a file may have it. */
    private Motion motion(List<Vec> points) {
        boolean loop = points.get(0).distanceTo(points.get(points.size() - 1)) > 10 && random.nextBoolean();
        return new Motion(awkward(0, 1000), loop, points);
    }

    private ObstacleShape shape() {
        return switch (random.nextInt(5)) {
            case 0 -> new ObstacleShape.Rectangle(extent(), extent());
            case 1 -> new ObstacleShape.Circle(extent());
            case 2 -> new ObstacleShape.Ellipse(extent(), extent());
            case 3 -> new ObstacleShape.Polygon(points(3));
            default -> new ObstacleShape.Wall(points(2));
        };
    }

    private List<Timed> event(RobotSpec robot, List<Obstacle> obstacles) {
        String sensor = robot.sensors().get(random.nextInt(robot.sensors().size())).id();
        double at = awkward(0, 1e6);
        return switch (random.nextInt(9)) {
            case 0 -> List.of(new Timed(at, new Command.SwitchSensor(sensor, random.nextBoolean())));
            case 1 -> List.of(new Timed(at, new Command.TuneSensor(sensor(sensor))));
            case 2 -> List.of(new Timed(at, new Command.InjectFault(sensor, fault())));
            case 3 -> List.of(new Timed(at, new Command.ClearFault(sensor, fault())));
            case 4 -> List.of(new Timed(at, new Command.ClearFaults(sensor)));
            case 5 -> passing(sensor, at, fault());
            case 6 -> List.of(new Timed(at, new Command.SetPlatform(size(), size(), positive(1000))));
            case 7 -> List.of(new Timed(at, new Command.PutObstacle(obstacle(name(), true))));
            default -> obstacles.isEmpty() ? List.of() : ofObstacle(at, obstacles.get(random.nextInt(obstacles.size())).id());
        };
    }

    /** A fault and its mending, side by side; now and then the mending is not later, so that it may not be joined to the fault. */
    private List<Timed> passing(String sensor, double at, Fault fault) {
        double until = random.nextInt(3) == 0 ? at : at + random.nextDouble();
        return List.of(new Timed(at, new Command.InjectFault(sensor, fault)), new Timed(until, new Command.ClearFault(sensor, fault)));
    }

    private List<Timed> ofObstacle(double at, String id) {
        Command command = random.nextBoolean() ? new Command.RemoveObstacle(id)
                : new Command.MoveObstacle(id, new Pose(coordinate(), coordinate(), angle()));
        return List.of(new Timed(at, command));
    }

    private Fault fault() {
        FaultKind kind = FaultKind.values()[random.nextInt(FaultKind.values().length)];
        return kind.fault(kind.least() + (kind.most() - kind.least()) * random.nextDouble());
    }

    private ControllerSpec controller() {
        return switch (random.nextInt(3)) {
            case 0 -> new ControllerSpec.None();
            case 1 -> new ControllerSpec.Drive(awkward(-1e4, 1e4), awkward(-1e4, 1e4));
            default -> new ControllerSpec.WallFollowing(size(), random.nextBoolean() ? Hand.LEFT : Hand.RIGHT, awkward(0, 10),
                    random.nextBoolean() ? Timing.EQUAL_READINGS : Timing.RANGE);
        };
    }

    private Expectation expectation(ControllerSpec controller) {
        return new Expectation(random.nextBoolean() ? Optional.of(random.nextBoolean()) : Optional.empty(),
                random.nextBoolean() ? OptionalDouble.of(random.nextDouble()) : OptionalDouble.empty(),
                random.nextBoolean() ? OptionalDouble.of(size()) : OptionalDouble.empty(),
                random.nextBoolean() ? List.of(controller.firstState()) : List.of(),
                random.nextBoolean() ? Optional.of(controller.firstState()) : Optional.empty());
    }

    private List<Vec> points(int least) {
        return list(least + random.nextInt(4), i -> point());
    }

    private <T> List<T> list(int size, IntFunction<T> maker) {
        return IntStream.range(0, size).mapToObj(maker).toList();
    }

    private Vec point() {
        return new Vec(coordinate(), coordinate());
    }

    private double size() {
        return awkward(1e-6, 1e5);
    }

    /** Of an obstacle: too small to reach the robot. */
    private double extent() {
        return awkward(1e-6, 1000);
    }

    private double positive(double most) {
        return awkward(Double.MIN_VALUE, most);
    }

    /** Never far to the left, where the robot starts. */
    private double coordinate() {
        return random.nextInt(8) == 0 ? -0.0 : awkward(-100, 1000);
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
    private double awkward(double least, double most) {
        double value = switch (random.nextInt(3)) {
            case 0 -> AWKWARD[random.nextInt(AWKWARD.length)];
            case 1 -> least + (most - least) * random.nextDouble();
            default -> random.nextInt(1000) / 100.0;
        };
        return Math.max(least, Math.min(most, value));
    }

    private String name() {
        return NAMES[random.nextInt(NAMES.length)];
    }
}
