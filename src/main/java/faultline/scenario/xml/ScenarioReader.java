package faultline.scenario.xml;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.io.MessageText;
import faultline.world.Clearance;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;

/** Reads a scenario, or reports everything that is wrong with it. */
public final class ScenarioReader {

    private static final List<String> CHILD_ELEMENTS =
            List.of("description", "world", "robot", "controller", "timeline", "expect");

    private final Problems problems;
    private final ObstacleReader obstacleReader;
    private final WorldReader worldReader;

    /** The attributes of the root element. */
    private record Header(String name, String description, boolean recorded, double duration, double tick, long seed) {}

    private ScenarioReader(Problems problems) {
        this.problems = problems;
        this.obstacleReader = new ObstacleReader(problems);
        this.worldReader = new WorldReader(problems, obstacleReader);
    }

    /**
     * Reads a scenario from the content of a file.
     *
     * @param file the name of the file in problems
     * @throws ScenarioException with everything that is wrong
     */
    static ScenarioContent read(String file, byte[] bytes) throws ScenarioException {
        Problems problems = new Problems(file);
        XmlParser parsing = new XmlParser(bytes, problems, XmlFormat.SCENARIO);
        Optional<XmlElement> root = parsing.parse();
        problems.throwIfAny();
        return read(file, root.orElseThrow());
    }

    /**
     * {@return the content of a scenario with a tree of elements}
     *
     * @param file the name of the file in problems
     * @param root the root element
     * @throws ScenarioException with everything that is wrong
     */
    public static ScenarioContent read(String file, XmlElement root) throws ScenarioException {
        Problems problems = new Problems(file);
        Optional<ScenarioContent> scenario = new ScenarioReader(problems).read(root);
        problems.throwIfAny();
        return scenario.orElseThrow();
    }

    private Optional<ScenarioContent> read(XmlElement root) {
        if (!root.name().equals("scenario")) {
            problems.add(root, ProblemKind.ROOT.with(MessageText.oneLine(root.name()), XmlFormat.SCENARIO.namespace()));
            return Optional.empty();
        }
        ElementRules.checkChildren(root, CHILD_ELEMENTS, problems);
        ElementRules.checkAtMostOne(root, CHILD_ELEMENTS, problems);
        return readSections(root);
    }

    /** Reads every section, so that all problems are reported together. */
    private Optional<ScenarioContent> readSections(XmlElement root) {
        Header head = readHeader(root);
        Optional<WorldSpec> world = requiredSection(root, "world").map(worldReader::read);
        Optional<RobotReader.PlacedRobot> robot = requiredSection(root, "robot").map(new RobotReader(problems)::read);
        ControllerSpec controller = root.firstChild("controller")
                .map(node -> ControllerXml.read(node, problems))
                .orElse(ControllerSpec.WallFollowing.DEFAULT);
        Expectation expect = root.firstChild("expect")
                .map(new ExpectationReader(problems, controller)::read)
                .orElse(Expectation.NONE);
        if (world.isEmpty() || robot.isEmpty()) {
            return Optional.empty();
        }
        SimulationSetup setup = SimulationSetup.of(world.get(), robot.get().start())
                .withRobot(robot.get().spec())
                .withController(controller)
                .withTimeline(readTimeline(root, robot.get(), controller))
                .withTick(head.tick)
                .withSeed(head.seed)
                .withDuration(head.duration);
        if (problems.isEmpty()) {
            checkStart(root.firstChild("robot").orElseThrow(), setup, problems);
        }
        return Optional.of(new ScenarioContent(head.name, head.description, head.recorded, setup, expect));
    }

    private Header readHeader(XmlElement root) {
        AttributeReader fields = new AttributeReader(root, problems);
        Header head = new Header(
                fields.text("name", ScenarioLimits.MAX_NAME_LENGTH).orElse(""),
                root.firstChild("description").map(this::readDescription).orElse(""),
                fields.flag("recorded", false),
                fields.number("duration", NumberRange.TIME, SimulationSetup.DEFAULT_DURATION),
                fields.number("tick", NumberRange.TICK, SimulationSetup.DEFAULT_TICK),
                fields.integer("seed", Long.MIN_VALUE, Long.MAX_VALUE, SimulationSetup.DEFAULT_SEED));
        fields.reportUnknownAndMissing();
        return head;
    }

    private String readDescription(XmlElement node) {
        String text = ElementRules.readText(node, problems);
        if (text.length() > ScenarioLimits.MAX_DESCRIPTION_LENGTH) {
            problems.add(
                    node,
                    ProblemKind.TEXT_LENGTH.with(node.name(), text.length(), ScenarioLimits.MAX_DESCRIPTION_LENGTH));
        }
        return text;
    }

    /** Must be called after the world and the robot, whose ids the timeline names. */
    private List<TimedCommand> readTimeline(XmlElement root, RobotReader.PlacedRobot robot, ControllerSpec controller) {
        return root.firstChild("timeline")
                .map(node -> new TimelineReader(problems, obstacleReader, robot.spec(), controller, worldReader.ids())
                        .read(node))
                .orElse(List.of());
    }

    private Optional<XmlElement> requiredSection(XmlElement root, String name) {
        Optional<XmlElement> section = root.firstChild(name);
        if (section.isEmpty()) {
            problems.add(root, ProblemKind.MISSING_ELEMENT.with(name));
        }
        return section;
    }

    private static void checkStart(XmlElement robot, SimulationSetup setup, Problems problems) {
        WorldSpec world = setup.world();
        Vector2 start = setup.start().position();
        if (world.enclosed()
                && !(start.x() > 0 && start.x() < world.width() && start.y() > 0 && start.y() < world.height())) {
            problems.add(
                    robot,
                    ProblemKind.START_OUTSIDE.with(
                            formatPoint(start), DecimalText.format(world.width()), DecimalText.format(world.height())));
            return;
        }
        Clearance.findObstruction(world, setup.robot(), setup.start())
                .ifPresent(obstacle -> problems.add(
                        robot, ProblemKind.START_OVERLAPS.with(formatPoint(start), MessageText.excerpt(obstacle))));
    }

    private static String formatPoint(Vector2 start) {
        return DecimalText.format(start.x()) + "," + DecimalText.format(start.y());
    }
}
