package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.GainRule;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.floorplan.MapDescription;
import faultline.geometry.Disc;
import faultline.geometry.Ellipse;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The public records of the model refuse numbers outside the limits that their documentation states. */
class RecordLimitsTest {

    private static final Path SOURCES = Path.of("src/main/java/faultline");
    private static final List<String> FOLDERS =
            List.of("geometry", "sensor", "robot", "world", "control", "engine", "scenario", "floorplan");

    /** Values that the program computes: their limits describe the results. */
    private static final Set<String> RESULTS =
            Set.of("SensorHealth", "RunMeasures", "RunResult", "MountedCone", "DecisionText");

    private static final WorldSpec WORLD = new WorldSpec(4, 3, true, 3, List.of());
    private static final List<Vector2> TRIANGLE = List.of(Vector2.ZERO, new Vector2(1, 0), new Vector2(0, 1));

    private static final Pattern RECORD =
            Pattern.compile("/\\*\\*((?:(?!\\*/).)*)\\*/\\s*(public )?record (\\w+)\\(", Pattern.DOTALL);
    private static final Pattern PARAMETER = Pattern.compile("@param (\\w+) ((?:(?! @).)*)");
    private static final Pattern INTERVAL = Pattern.compile("\\bin ([\\[(])([\\d.]+), ([\\d.]+)([\\])])");

    /** One valid record of each kind whose documentation states limits. */
    private static List<Record> samples() {
        Pose pose = new Pose(1, 1, 0);
        RigidMotion frame = new RigidMotion(1, 0, 0, 0);
        RobotSpec robot = RobotSpec.DEFAULT;
        Command command = new Command.ClearFaults("left");
        List<Record> samples = new ArrayList<>(List.of(
                new Disc(0, 0, 1),
                new Ellipse(frame, 2, 1),
                new OrientedBox(frame, 2, 1),
                pose,
                Sector.of(Vector2.ZERO, 0, 0.4, 1),
                robot,
                robot.sensors().get(0),
                MotorSpec.DEFAULT,
                WORLD,
                new Obstacle("post", new ObstacleShape.CircleShape(0.1), pose, WaypointPath.NONE, Obstacle.MATT),
                new ObstacleShape.RectangleShape(1, 2),
                new ObstacleShape.CircleShape(1),
                new ObstacleShape.EllipseShape(1, 2),
                new WaypointPath(1, true, TRIANGLE),
                new Command.SetPlatform(0.25, 0.2, 0.3),
                new ControllerSpec.Drive(1, 2),
                ControllerSpec.WallFollowing.DEFAULT,
                new ControllerSpec.Extern(0, 0.3),
                new ControllerSpec.Provided("mine", 0, 0.3, Map.of()),
                new GainRule.Length(1),
                new GainRule.Fixed(1, 2),
                SimulationSetup.of(WORLD, pose),
                new SimulationSetup.TimedCommand(1, command),
                new Expectation.MinCoverage(0.5),
                new Expectation.MaxDistanceRms(0.1),
                MapDescription.of(Path.of("map.png"), BigDecimal.ONE)));
        Arrays.stream(FaultKind.values())
                .filter(FaultKind::takesValue)
                .map(kind -> (Record) kind.createFault(kind.defaultValue()))
                .forEach(samples::add);
        return samples;
    }

    /** Returns the values that a description of a number excludes. */
    private static List<Double> excluded(String description) {
        List<Double> values = new ArrayList<>();
        if (description.matches("(.*, )?positive(;.*)?")) {
            values.addAll(List.of(0.0, -1.0, Double.POSITIVE_INFINITY));
        }
        if (description.matches("(.*, )?not negative(;.*)?")) {
            values.addAll(List.of(-1.0, Double.POSITIVE_INFINITY));
        }
        if (description.matches(".*[,;] (any )?finite.*")) {
            values.addAll(List.of(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY));
        }
        Matcher interval = INTERVAL.matcher(description);
        if (interval.find()) {
            double low = Double.parseDouble(interval.group(2));
            double high = Double.parseDouble(interval.group(3));
            values.add(interval.group(1).equals("[") ? low - 0.001 : low);
            values.add(interval.group(4).equals("]") ? high + 0.001 : high);
        }
        if (!values.isEmpty()) {
            values.add(Double.NaN);
        }
        return values;
    }

    /** Returns the descriptions of the components of all public records, by the names of the records. */
    private static Map<String, Map<String, String>> descriptions() throws IOException {
        Map<String, Map<String, String>> found = new TreeMap<>();
        for (String folder : FOLDERS) {
            try (Stream<Path> files = Files.walk(SOURCES.resolve(folder))) {
                for (Path file :
                        files.filter(path -> path.toString().endsWith(".java")).toList()) {
                    String source = Files.readString(file);
                    boolean membersArePublic = source.contains("public sealed interface");
                    RECORD.matcher(source)
                            .results()
                            .filter(text -> text.group(2) != null || membersArePublic)
                            .forEach(text -> found.put(text.group(3), parameters(text)));
                }
            }
        }
        return found;
    }

    private static Map<String, String> parameters(MatchResult text) {
        String comment = text.group(1).replaceAll("\\s+\\*?\\s*", " ").strip();
        return PARAMETER
                .matcher(comment)
                .results()
                .collect(Collectors.toMap(
                        found -> found.group(1), found -> found.group(2).strip()));
    }

    private static boolean refuses(Record sample, RecordComponent changed, double value) throws Exception {
        RecordComponent[] components = sample.getClass().getRecordComponents();
        Class<?>[] types =
                Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
        Object[] values = new Object[components.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = components[i].getAccessor().invoke(sample);
            if (components[i].getName().equals(changed.getName())) {
                values[i] = types[i] == int.class ? (Object) (int) value : (Object) value;
            }
        }
        Constructor<? extends Record> constructor = sample.getClass().getDeclaredConstructor(types);
        try {
            constructor.newInstance(values);
            return false;
        } catch (InvocationTargetException e) {
            return e.getCause() instanceof IllegalArgumentException;
        }
    }

    @Test
    void aRecordRefusesNumbersOutsideItsLimits() throws Exception {
        Map<String, Map<String, String>> descriptions = descriptions();
        List<String> accepted = new ArrayList<>();
        int checks = 0;
        for (Record sample : samples()) {
            Map<String, String> ofSample = descriptions.get(sample.getClass().getSimpleName());
            for (RecordComponent component : sample.getClass().getRecordComponents()) {
                boolean whole = component.getType() == int.class;
                if (component.getType() != double.class && !whole) {
                    continue;
                }
                for (double value : excluded(ofSample.get(component.getName()))) {
                    if (whole && value != Math.rint(value) || whole && Double.isInfinite(value)) {
                        continue;
                    }
                    checks++;
                    if (!refuses(sample, component, value)) {
                        accepted.add(sample.getClass().getSimpleName() + " " + component.getName() + " " + value);
                    }
                }
            }
        }
        assertEquals(List.of(), accepted);
        assertTrue(checks > 100, checks + " checks");
    }

    @Test
    void everyRecordThatStatesLimitsIsChecked() throws IOException {
        Set<String> checked = new HashSet<>(RESULTS);
        samples().forEach(sample -> checked.add(sample.getClass().getSimpleName()));
        List<String> unchecked = descriptions().entrySet().stream()
                .filter(found -> found.getValue().values().stream()
                        .anyMatch(text -> !excluded(text).isEmpty()))
                .map(Map.Entry::getKey)
                .filter(name -> !checked.contains(name))
                .toList();
        assertEquals(List.of(), unchecked);
    }

    @Test
    void limitsAreReadFromSentences() {
        assertEquals(List.of(0.0, -1.0, Double.POSITIVE_INFINITY, Double.NaN), excluded("metres, positive"));
        assertEquals(List.of(-0.001, 1.0, Double.NaN), excluded("the sine, in [0, 1)"));
        assertEquals(List.of(), excluded("the error, metres, positive for too far"));
    }
}
