package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.io.DecimalText;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.XmlElement;
import faultline.sensor.FaultDescriptor;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Reads the commands of the timeline, with one method for each element. */
final class TimelineReader {

    private static final Map<String, Allowed> FAULT_UNITS = Map.of(
            "m",
            Allowed.METRES,
            "deg",
            Allowed.DEGREES,
            "s",
            Allowed.SECONDS,
            "m/s",
            Allowed.SPEED,
            "V",
            Allowed.VOLTS);
    private static final NumberRange FAULT_LENGTH =
            NumberRange.closed(FaultKind.MIN_LENGTH, FaultKind.MAX_LENGTH, Allowed.SECONDS);

    private static final double NEVER = NumberRange.TIME.max().doubleValue() + 1;

    /** Reads the commands of one element. */
    private interface CommandReader {
        Stream<TimedCommand> read(XmlElement node, AttributeReader fields, double at);
    }

    private final Problems problems;
    private final ObstacleReader obstacleReader;
    private final RobotSpec robot;
    private final Map<String, SensorSpec> sensors = new LinkedHashMap<>();
    private final ControllerSpec.WallFollowing follower;
    private final Set<String> obstacleIds;
    private final Map<String, CommandReader> readers = new LinkedHashMap<>();

    TimelineReader(
            Problems problems,
            ObstacleReader obstacleReader,
            RobotSpec robot,
            ControllerSpec controller,
            Set<String> obstacleIds) {
        this.problems = problems;
        this.obstacleReader = obstacleReader;
        this.robot = robot;
        this.follower = ControllerReader.defaultsFor(controller);
        this.obstacleIds = new LinkedHashSet<>(obstacleIds);
        robot.sensors().forEach(sensor -> sensors.put(sensor.id(), sensor));
        readers.put("fault", this::readFault);
        readers.put("mend", this::readMend);
        readers.put("switch", this::readSwitch);
        readers.put("tune", this::readTune);
        readers.put("move", this::readMove);
        readers.put("put", this::readPut);
        readers.put("remove", this::readRemove);
        readers.put("platform", this::readPlatform);
        readers.put("controller", this::readController);
    }

    List<TimedCommand> read(XmlElement timeline) {
        ElementRules.checkChildren(timeline, readers.keySet(), problems);
        new AttributeReader(timeline, problems).reportUnknownAndMissing();
        timeline.childrenNamed("put").flatMap(node -> node.children().stream()).forEach(child -> Optional.ofNullable(
                        child.attributes().get("id"))
                .ifPresent(obstacleIds::add));
        List<TimedCommand> commands = new ArrayList<>();
        for (XmlElement node : timeline.children()) {
            Optional.ofNullable(readers.get(node.name()))
                    .ifPresent(handler -> read(node, handler).forEach(commands::add));
        }
        return commands;
    }

    private Stream<TimedCommand> read(XmlElement node, CommandReader handler) {
        ElementRules.checkChildren(
                node, node.name().equals("put") ? obstacleReader.elementNames() : List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        double at = fields.number("at", NumberRange.TIME);
        List<TimedCommand> commands = handler.read(node, fields, at).toList();
        fields.reportUnknownAndMissing();
        return commands.stream();
    }

    private Stream<TimedCommand> readFault(XmlElement node, AttributeReader fields, double at) {
        double until = readUntil(node, fields, at);
        if (fields.isPresent("motor")) {
            Optional<MotorSide> motor = readMotors(fields);
            Optional<MotorFault> fault = readFault(fields, MotorFaultKind.values());
            return motor.stream().flatMap(side -> fault.stream()
                    .flatMap(broken -> interval(
                            new TimedCommand(at, new Command.InjectMotorFault(side, broken)),
                            new TimedCommand(until, new Command.ClearMotorFault(side, broken)))));
        }
        String sensor = readSensorId(fields);
        return readFault(fields, FaultKind.values()).stream()
                .flatMap(fault -> interval(
                        new TimedCommand(at, new Command.InjectFault(sensor, fault)),
                        new TimedCommand(until, new Command.ClearFault(sensor, fault))));
    }

    /** Returns when a fault ends, NEVER if it does not. */
    private double readUntil(XmlElement node, AttributeReader fields, double at) {
        if (!fields.isPresent("until")) {
            return NEVER;
        }
        double until = fields.number("until", NumberRange.TIME);
        if (until <= at && fields.isNumber("at", NumberRange.TIME) && fields.isNumber("until", NumberRange.TIME)) {
            problems.add(node, ProblemKind.UNTIL.with(DecimalText.format(until), DecimalText.format(at)));
        }
        return until;
    }

    private static Stream<TimedCommand> interval(TimedCommand start, TimedCommand end) {
        return end.time() == NEVER ? Stream.of(start) : Stream.of(start, end);
    }

    private Stream<TimedCommand> readMend(XmlElement node, AttributeReader fields, double at) {
        if (fields.isPresent("motor")) {
            return readMotorMend(fields).map(command -> new TimedCommand(at, command));
        }
        String sensor = readSensorId(fields);
        if (fields.isPresent("kind") || fields.isPresent("value")) {
            return readFault(fields, FaultKind.values()).stream()
                    .map(fault -> new TimedCommand(at, new Command.ClearFault(sensor, fault)));
        }
        return singleCommand(at, new Command.ClearFaults(sensor));
    }

    private static Stream<Command> readMotorMend(AttributeReader fields) {
        Optional<MotorSide> motor = readMotors(fields);
        if (fields.isPresent("kind") || fields.isPresent("value")) {
            Optional<MotorFault> fault = readFault(fields, MotorFaultKind.values());
            return motor.stream().flatMap(side -> fault.stream().map(old -> new Command.ClearMotorFault(side, old)));
        }
        return motor.stream().map(Command.ClearMotorFaults::new);
    }

    private Stream<TimedCommand> readSwitch(XmlElement node, AttributeReader fields, double at) {
        return singleCommand(at, new Command.SwitchSensor(readSensorId(fields), fields.flag("on")));
    }

    private Stream<TimedCommand> readTune(XmlElement node, AttributeReader fields, double at) {
        SensorSpec defaults = sensors.getOrDefault(
                readSensorId(fields), RobotSpec.DEFAULT.sensors().get(0));
        return singleCommand(at, new Command.ConfigureSensor(RobotReader.readAttributes(fields, defaults)));
    }

    private Stream<TimedCommand> readMove(XmlElement node, AttributeReader fields, double at) {
        Pose pose = new Pose(
                fields.number("x", NumberRange.COORDINATE),
                fields.number("y", NumberRange.COORDINATE),
                fields.angle("heading", NumberRange.ANGLE, 0));
        return singleCommand(at, new Command.MoveObstacle(readObstacleId(fields), pose));
    }

    private Stream<TimedCommand> readPut(XmlElement node, AttributeReader fields, double at) {
        List<XmlElement> inside = node.children().stream()
                .filter(child -> obstacleReader.elementNames().contains(child.name()))
                .toList();
        if (inside.size() != 1) {
            problems.add(
                    node, ProblemKind.OBSTACLE_COUNT.with(inside.size(), Allowed.names(obstacleReader.elementNames())));
            return Stream.empty();
        }
        Obstacle obstacle = obstacleReader.read(inside.get(0));
        if (obstacle.id().equals(WorldSpec.ENCLOSURE)) {
            problems.add(inside.get(0), WorldReader.reservedId(inside.get(0)));
        }
        return singleCommand(at, new Command.PlaceObstacle(obstacle));
    }

    private Stream<TimedCommand> readRemove(XmlElement node, AttributeReader fields, double at) {
        return singleCommand(at, new Command.RemoveObstacle(readObstacleId(fields)));
    }

    private Stream<TimedCommand> readPlatform(XmlElement node, AttributeReader fields, double at) {
        return singleCommand(
                at,
                new Command.SetPlatform(
                        fields.number("length", NumberRange.SIZE, robot.length()),
                        fields.number("width", NumberRange.SIZE, robot.width()),
                        fields.number("speed", NumberRange.POSITIVE_SPEED, robot.speed())));
    }

    private Stream<TimedCommand> readController(XmlElement node, AttributeReader fields, double at) {
        return singleCommand(at, new Command.ConfigureController(ControllerReader.readBuiltIn(fields, follower)));
    }

    private static Stream<TimedCommand> singleCommand(double at, Command command) {
        return Stream.of(new TimedCommand(at, command));
    }

    private String readSensorId(AttributeReader fields) {
        return readKnownId(fields, "sensor", sensors.keySet(), Allowed.SENSORS);
    }

    private String readObstacleId(AttributeReader fields) {
        return readKnownId(fields, "obstacle", obstacleIds, Allowed.OBSTACLES);
    }

    private static String readKnownId(AttributeReader fields, String attribute, Set<String> ids, Allowed rule) {
        String id = fields.id(attribute);
        if (fields.isValid(attribute, id) && !ids.contains(id)) {
            fields.reportValue(
                    attribute,
                    id,
                    () -> ids.isEmpty()
                            ? Allowed.NO_IDS.with()
                            : Allowed.withHint(rule.with(Allowed.names(ids)), id, ids));
        }
        return id;
    }

    /** Returns the fault that the attributes kind, value and length describe, unless the kind is unknown. */
    private static <K extends FaultDescriptor<F>, F> Optional<F> readFault(AttributeReader fields, K[] kinds) {
        Optional<F> fault = fields.choice("kind", kinds, FaultDescriptor::fileName)
                .map(kind -> kind.createFault(readFaultValue(fields, kind), readFaultLength(fields, kind)));
        // An unknown kind is reported alone, without its value.
        fields.isPresent("value");
        return fault;
    }

    /** Returns the side that the attribute {@code motor} names, if it is valid. */
    private static Optional<MotorSide> readMotors(AttributeReader fields) {
        return fields.choice("motor", MotorSide.values(), MotorSide::fileName);
    }

    private static double readFaultValue(AttributeReader fields, FaultDescriptor<?> kind) {
        if (kind.takesValue()) {
            NumberRange range = NumberRange.closed(
                    kind.minValue(), kind.maxValue(), FAULT_UNITS.getOrDefault(kind.unit(), Allowed.UNITLESS));
            return fields.number("value", range, kind.defaultValue());
        }
        fields.text("value").ifPresent(text -> fields.report("value", text, Allowed.NO_VALUE.with(kind.fileName())));
        return 0;
    }

    private static double readFaultLength(AttributeReader fields, FaultDescriptor<?> kind) {
        return kind.takesLength()
                ? fields.number("length", FAULT_LENGTH, FaultKind.DEFAULT_LENGTH)
                : FaultKind.DEFAULT_LENGTH;
    }
}
