package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.engine.Setup;
import faultline.engine.Setup.Timed;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;

/** Makes a scenario of a file's bytes, or says all that is wrong with them. */
final class ScenarioReader {

    private static final List<String> INSIDE = List.of("description", "world", "robot", "controller", "timeline", "expect");

    private final Complaints complaints;
    private final ObstacleReader obstacles;
    private final WorldReader worlds;

    /** What the root element itself says. */
    private record Head(String name, String description, boolean recorded, double duration, double tick, long seed) {
    }

    private ScenarioReader(Complaints complaints) {
        this.complaints = complaints;
        this.obstacles = new ObstacleReader(complaints);
        this.worlds = new WorldReader(complaints, obstacles);
    }

    /**
     * Reads a scenario.
     *
     * @param file the name that complaints give it
     * @param bytes its content
     * @return the scenario
     * @throws ScenarioException with everything that is wrong
     */
    static Scenario read(String file, byte[] bytes) throws ScenarioException {
        Complaints complaints = new Complaints(file);
        XmlParsing parsing = new XmlParsing(bytes, complaints);
        Optional<Scenario> scenario = parsing.parse().flatMap(root -> new ScenarioReader(complaints).read(root));
        if (complaints.isEmpty()) {
            parsing.complainOfOffence();
        }
        complaints.throwIfAny();
        return scenario.orElseThrow();
    }

    private Optional<Scenario> read(Node root) {
        if (!root.name().equals("scenario")) {
            complaints.add(root, "the root element is <" + Quoting.oneLine(root.name()) + ">, allowed is <scenario xmlns=\""
                    + ScenarioSchema.NAMESPACE + "\">");
            return Optional.empty();
        }
        Content.check(root, INSIDE, complaints);
        Content.atMostOne(root, INSIDE, complaints);
        return scenario(root);
    }

    /** Reads every section, so that all complaints come at once. */
    private Optional<Scenario> scenario(Node root) {
        Head head = head(root);
        Optional<WorldSpec> world = section(root, "world").map(worlds::read);
        Optional<RobotReader.Placed> robot = section(root, "robot").map(new RobotReader(complaints)::read);
        ControllerSpec controller = root.first("controller").map(node -> ControllerReader.read(node, complaints))
                .orElse(ControllerSpec.WallFollowing.DEFAULT);
        Expectation expect = root.first("expect").map(new ExpectReader(complaints, controller)::read).orElse(Expectation.NONE);
        if (world.isEmpty() || robot.isEmpty()) {
            return Optional.empty();
        }
        Setup setup = new Setup(world.get(), robot.get().spec(), robot.get().start(), controller, timeline(root, robot.get()),
                head.tick, head.seed, head.duration);
        if (complaints.isEmpty()) {
            StartCheck.check(root.first("robot").orElseThrow(), setup, complaints);
        }
        return Optional.of(new Scenario(head.name, head.description, head.recorded, setup, expect));
    }

    private Head head(Node root) {
        Fields fields = new Fields(root, complaints);
        Head head = new Head(fields.text("name").orElse(""), root.first("description").map(node -> Content.text(node, complaints)).orElse(""),
                fields.flag("recorded", false), fields.number("duration", Range.TIME, Scenario.DEFAULT_DURATION),
                fields.number("tick", Range.TICK, Scenario.DEFAULT_TICK),
                fields.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE, Scenario.DEFAULT_SEED));
        fields.done();
        return head;
    }

    /** Comes after the world and the robot, whose ids it names. */
    private List<Timed> timeline(Node root, RobotReader.Placed robot) {
        return root.first("timeline").map(new TimelineReader(complaints, obstacles, robot.spec(), worlds.ids())::read).orElse(List.of());
    }

    private Optional<Node> section(Node root, String name) {
        Optional<Node> section = root.first(name);
        if (section.isEmpty()) {
            complaints.add(root, "<scenario> lacks the element <" + name + ">, allowed is one");
        }
        return section;
    }
}
