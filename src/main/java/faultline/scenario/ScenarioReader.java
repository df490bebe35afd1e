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

    private ScenarioReader(Complaints complaints) {
        this.complaints = complaints;
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

    /** Reads every section, so that all complaints come at once; the timeline only where there is something for it to name. */
    private Optional<Scenario> scenario(Node root) {
        String name = new Fields(root, complaints).text("name").orElse("");
        String description = root.first("description").map(node -> Content.text(node, complaints)).orElse("");
        ObstacleReader obstacles = new ObstacleReader(complaints);
        WorldReader worldReader = new WorldReader(complaints, obstacles);
        Optional<WorldSpec> world = section(root, "world").map(worldReader::read);
        Optional<RobotReader.Placed> robot = section(root, "robot").map(new RobotReader(complaints)::read);
        ControllerSpec controller = root.first("controller").map(node -> ControllerReader.read(node, complaints))
                .orElse(ControllerSpec.WallFollowing.DEFAULT);
        Expectation expect = root.first("expect").map(new ExpectReader(complaints, controller)::read).orElse(Expectation.NONE);
        if (world.isEmpty() || robot.isEmpty()) {
            return Optional.empty();
        }
        List<Timed> timeline = root.first("timeline")
                .map(new TimelineReader(complaints, obstacles, robot.get().spec(), worldReader.ids())::read).orElse(List.of());
        Setup setup = setup(root, world.get(), robot.get(), controller, timeline);
        if (complaints.isEmpty()) {
            StartCheck.check(root.first("robot").orElseThrow(), setup, complaints);
        }
        return Optional.of(new Scenario(name, description, setup, expect));
    }

    private Setup setup(Node root, WorldSpec world, RobotReader.Placed robot, ControllerSpec controller, List<Timed> timeline) {
        Fields fields = new Fields(root, complaints);
        fields.text("name");
        double duration = fields.number("duration", Range.TIME, Scenario.DEFAULT_DURATION);
        double tick = fields.number("tick", Range.TICK, Scenario.DEFAULT_TICK);
        long seed = fields.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE, Scenario.DEFAULT_SEED);
        fields.done();
        return new Setup(world, robot.spec(), robot.start(), controller, timeline, tick, seed, duration);
    }

    private Optional<Node> section(Node root, String name) {
        Optional<Node> section = root.first(name);
        if (section.isEmpty()) {
            complaints.add(root, "<scenario> lacks the element <" + name + ">, allowed is one");
        }
        return section;
    }
}
