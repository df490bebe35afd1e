package faultline.scenario;

import faultline.engine.Setup.Timed;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
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

/** Makes commands of the timeline's elements, one handler for each. */
final class TimelineReader {

    /** Reads one element: its time is known, its attributes are at hand, and what it comes to is put at the end of the list. */
    private interface Handler {
        Stream<Timed> read(Node node, Fields fields, double at);
    }

    private final Complaints complaints;
    private final ObstacleReader obstacles;
    private final RobotSpec robot;
    private final Map<String, SensorSpec> sensors = new LinkedHashMap<>();
    private final Set<String> obstacleIds;
    private final Map<String, Handler> handlers = new LinkedHashMap<>();

    TimelineReader(Complaints complaints, ObstacleReader obstacles, RobotSpec robot, Set<String> obstacleIds) {
        this.complaints = complaints;
        this.obstacles = obstacles;
        this.robot = robot;
        this.obstacleIds = new LinkedHashSet<>(obstacleIds);
        robot.sensors().forEach(sensor -> sensors.put(sensor.id(), sensor));
        handlers.put("fault", this::fault);
        handlers.put("mend", this::mend);
        handlers.put("switch", this::change);
        handlers.put("tune", this::tune);
        handlers.put("move", this::move);
        handlers.put("put", this::put);
        handlers.put("remove", this::remove);
        handlers.put("platform", this::platform);
    }

    List<Timed> read(Node timeline) {
        Content.check(timeline, handlers.keySet(), complaints);
        new Fields(timeline, complaints).done();
        timeline.all("put").flatMap(node -> node.children().stream())
                .forEach(child -> Optional.ofNullable(child.attributes().get("id")).ifPresent(obstacleIds::add));
        List<Timed> commands = new ArrayList<>();
        for (Node node : timeline.children()) {
            Optional.ofNullable(handlers.get(node.name())).ifPresent(handler -> read(node, handler).forEach(commands::add));
        }
        return commands;
    }

    private Stream<Timed> read(Node node, Handler handler) {
        Content.check(node, node.name().equals("put") ? obstacles.names() : List.of(), complaints);
        Fields fields = new Fields(node, complaints);
        double at = fields.number("at", Range.TIME);
        List<Timed> commands = handler.read(node, fields, at).toList();
        fields.done();
        return commands.stream();
    }

    private Stream<Timed> fault(Node node, Fields fields, double at) {
        String sensor = sensor(fields);
        Optional<Fault> fault = FaultFields.read(fields);
        Stream<Timed> breaks = fault.stream().map(broken -> new Timed(at, new Command.InjectFault(sensor, broken)));
        if (!fields.has("until")) {
            return breaks;
        }
        double until = fields.number("until", Range.TIME);
        if (until <= at) {
            complaints.add(node, "until of <fault> is " + Numbers.toText(until) + ", allowed is a time after at, which is " + Numbers.toText(at));
        }
        return Stream.concat(breaks, fault.stream().map(mended -> new Timed(until, new Command.ClearFault(sensor, mended))));
    }

    private Stream<Timed> mend(Node node, Fields fields, double at) {
        String sensor = sensor(fields);
        if (fields.has("kind") || fields.has("value")) {
            return FaultFields.read(fields).stream().map(fault -> new Timed(at, new Command.ClearFault(sensor, fault)));
        }
        return one(at, new Command.ClearFaults(sensor));
    }

    private Stream<Timed> change(Node node, Fields fields, double at) {
        return one(at, new Command.SwitchSensor(sensor(fields), fields.flag("on")));
    }

    private Stream<Timed> tune(Node node, Fields fields, double at) {
        SensorSpec usual = sensors.getOrDefault(sensor(fields), RobotSpec.DEFAULT.sensors().get(0));
        return one(at, new Command.TuneSensor(SensorFields.read(fields, usual)));
    }

    private Stream<Timed> move(Node node, Fields fields, double at) {
        Pose pose = new Pose(fields.number("x", Range.COORDINATE), fields.number("y", Range.COORDINATE),
                fields.angle("heading", Range.ANGLE, 0));
        return one(at, new Command.MoveObstacle(obstacle(fields), pose));
    }

    private Stream<Timed> put(Node node, Fields fields, double at) {
        List<Node> inside = node.children().stream().filter(child -> obstacles.names().contains(child.name())).toList();
        if (inside.size() != 1) {
            complaints.add(node, "<put> holds " + inside.size() + " obstacles, allowed is one of " + Quoting.list(obstacles.names()));
            return Stream.empty();
        }
        Obstacle obstacle = obstacles.read(inside.get(0));
        if (obstacle.id().equals(WorldSpec.ENCLOSURE)) {
            complaints.add(inside.get(0), WorldReader.reserved(inside.get(0)));
        }
        return one(at, new Command.PutObstacle(obstacle));
    }

    private Stream<Timed> remove(Node node, Fields fields, double at) {
        return one(at, new Command.RemoveObstacle(obstacle(fields)));
    }

    private Stream<Timed> platform(Node node, Fields fields, double at) {
        return one(at, new Command.SetPlatform(fields.number("length", Range.SIZE, robot.length()),
                fields.number("width", Range.SIZE, robot.width()), fields.number("speed", Range.POSITIVE_SPEED, robot.speed())));
    }

    private static Stream<Timed> one(double at, Command command) {
        return Stream.of(new Timed(at, command));
    }

    private String sensor(Fields fields) {
        return known(fields, "sensor", sensors.keySet(), "the robot's sensors");
    }

    private String obstacle(Fields fields) {
        return known(fields, "obstacle", obstacleIds, "the obstacles");
    }

    private static String known(Fields fields, String attribute, Set<String> ids, String what) {
        String id = fields.id(attribute);
        if (fields.has(attribute) && !ids.contains(id) && !id.equals("?")) {
            fields.complain(attribute, id, (ids.isEmpty() ? "none: there are none" : "one of " + what + ": " + Quoting.list(ids))
                    + Spelling.hint(id, ids));
        }
        return id;
    }
}
