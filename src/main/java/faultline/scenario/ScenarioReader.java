package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.engine.ControllerFactory;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.io.MessageText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import faultline.scenario.xml.XmlFile;
import faultline.scenario.xml.XmlFormat;
import faultline.world.Clearance;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Reads a scenario, or reports everything that is wrong with it. */
final class ScenarioReader {

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

    static Scenario read(Path file) throws ScenarioException {
        return read(file.toString(), XmlFile.readBytes(file, Allowed.SCENARIO_FILE.with()));
    }

    /** Returns a scenario that is part of the program; the name is that of a file in the folder {@code scenarios}. */
    static Scenario readShipped(String name) throws ScenarioException {
        try (InputStream in = ScenarioReader.class.getResourceAsStream("/scenarios/" + name)) {
            if (in == null) {
                throw new ScenarioException(name, ProblemKind.NOT_SHIPPED.with());
            }
            return read(name, in.readAllBytes());
        } catch (IOException e) {
            throw new ScenarioException(name, ProblemKind.UNREADABLE_RESOURCE.with());
        }
    }

    /** Returns the scenario in a file with some bytes; the name of the file is for problems. */
    static Scenario read(String file, byte[] bytes) throws ScenarioException {
        Problems problems = new Problems(file);
        if (bytes.length == 0) {
            problems.add(new SourceLocation(1, 1), ProblemKind.EMPTY_FILE.with());
        }
        problems.throwIfAny();
        Optional<XmlElement> root = XmlElement.parse(bytes, problems, XmlFormat.SCENARIO);
        problems.throwIfAny();
        return read(file, root.orElseThrow());
    }

    /** Returns the scenario in a tree of elements; the name of the file is for problems. */
    static Scenario read(String file, XmlElement root) throws ScenarioException {
        Problems problems = new Problems(file);
        Optional<Scenario> scenario = new ScenarioReader(problems).read(root);
        problems.throwIfAny();
        return scenario.orElseThrow();
    }

    private Optional<Scenario> read(XmlElement root) {
        if (!root.name().equals("scenario")) {
            problems.add(root, ProblemKind.ROOT.with(MessageText.oneLine(root.name()), XmlFormat.SCENARIO.namespace()));
            return Optional.empty();
        }
        ElementRules.checkChildren(root, CHILD_ELEMENTS, problems);
        ElementRules.checkAtMostOne(root, CHILD_ELEMENTS, problems);
        return readSections(root);
    }

    /** Reads every section, so that all problems are reported together. */
    private Optional<Scenario> readSections(XmlElement root) {
        Header head = readHeader(root);
        Optional<WorldSpec> world = requiredSection(root, "world").map(worldReader::read);
        Optional<RobotReader.PlacedRobot> robot = requiredSection(root, "robot").map(new RobotReader(problems)::read);
        ControllerSpec controller = root.firstChild("controller")
                .map(node -> ControllerReader.read(node, problems))
                .orElse(ControllerSpec.WallFollowing.DEFAULT);
        if (world.isEmpty() || robot.isEmpty()) {
            readExpectation(root, ExpectElement.possibleStates(root));
            return Optional.empty();
        }
        SimulationSetup setup = SimulationSetup.of(world.get(), robot.get().start())
                .withRobot(robot.get().spec())
                .withController(controller)
                .withTimeline(readTimeline(root, robot.get(), controller))
                .withTick(head.tick)
                .withSeed(head.seed)
                .withDuration(head.duration);
        Expectation expect = readExpectation(root, ControllerFactory.statesInRun(setup));
        if (problems.isEmpty()) {
            checkStart(root.firstChild("robot").orElseThrow(), setup, problems);
        }
        return Optional.of(new Scenario(head.name, head.description, head.recorded, setup, expect));
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

    private Expectation readExpectation(XmlElement root, List<ControllerState> states) {
        return root.firstChild("expect")
                .map(new ExpectationReader(problems, states)::read)
                .orElse(Expectation.NONE);
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
                && !(start.x() >= 0 && start.x() <= world.width() && start.y() >= 0 && start.y() <= world.height())) {
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
