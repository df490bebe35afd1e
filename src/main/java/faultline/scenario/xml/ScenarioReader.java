package faultline.scenario.xml;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Vector2;
import faultline.io.ByteCount;
import faultline.io.DecimalText;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.world.Clearance;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
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
     * {@return the content of a scenario file}
     *
     * @param file the file
     * @throws ScenarioException with everything that is wrong with the file
     */
    public static ScenarioContent read(Path file) throws ScenarioException {
        return read(file.toString(), readBytes(file, Allowed.SCENARIO_FILE.with()));
    }

    /**
     * {@return the content of a scenario that is part of the program}
     *
     * @param name the name of a file in the folder {@code scenarios}
     * @throws ScenarioException if there is none of that name
     */
    public static ScenarioContent readShipped(String name) throws ScenarioException {
        try (InputStream in = ScenarioReader.class.getResourceAsStream("/scenarios/" + name)) {
            if (in == null) {
                throw problem(name, ProblemKind.NOT_SHIPPED.with());
            }
            return read(name, in.readAllBytes());
        } catch (IOException e) {
            throw problem(name, ProblemKind.UNREADABLE_RESOURCE.with());
        }
    }

    /**
     * {@return the content of a scenario file with some bytes}
     *
     * @param file the name of the file in problems
     * @param bytes the content
     * @throws ScenarioException with everything that is wrong with it
     */
    public static ScenarioContent read(String file, byte[] bytes) throws ScenarioException {
        Problems problems = new Problems(file);
        if (bytes.length == 0) {
            problems.add(new SourceLocation(1, 1), ProblemKind.EMPTY_FILE.with());
        }
        problems.throwIfAny();
        Optional<XmlElement> root = XmlElement.parse(bytes, problems, XmlFormat.SCENARIO);
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

    /**
     * {@return the bytes of a file}
     *
     * @param file the file
     * @param kind the expected kind of file, such as {@link Allowed#SCENARIO_FILE}, for problems
     * @throws ScenarioException if the file cannot be read, or is too large
     */
    public static byte[] readBytes(Path file, Object kind) throws ScenarioException {
        String name = file.toString();
        try {
            checkRegularFile(name, file, kind);
            return Files.readAllBytes(file);
        } catch (NoSuchFileException e) {
            throw problem(name, ProblemKind.NO_SUCH_FILE.with());
        } catch (IOException e) {
            throw problem(name, ProblemKind.UNREADABLE_FILE.with());
        }
    }

    /** Checked before anything is read: a device or a pipe could continue without end. */
    private static void checkRegularFile(String name, Path file, Object kind) throws ScenarioException, IOException {
        if (Files.isDirectory(file)) {
            throw problem(name, ProblemKind.FOLDER.with(kind));
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw problem(name, ProblemKind.IRREGULAR_FILE.with(kind));
        }
        if (Files.size(file) > ScenarioLimits.MAX_BYTES) {
            throw problem(
                    name,
                    ProblemKind.TOO_MANY_BYTES.with(
                            ByteCount.format(Files.size(file)), ByteCount.format(ScenarioLimits.MAX_BYTES)));
        }
    }

    private static ScenarioException problem(String name, Message message) {
        return new ScenarioException(List.of(new Problem(name, SourceLocation.NONE, message)));
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
