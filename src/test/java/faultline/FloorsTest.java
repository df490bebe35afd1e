package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Checks the layers and the size of the sources, decision 0001, and shows on seeded violations that each rule can fail.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class FloorsTest {

    private static final Path ROOT = Path.of("src/main/java/faultline");
    private static final int MAX_METHOD_LINES = 40;
    private static final int MAX_LINE_LENGTH = 120;
    private static final int MAX_FILES_PER_PACKAGE = 34;

    private SourceMetrics all;
    private Map<String, Set<String>> packages;

    @BeforeAll
    void readAll() throws IOException {
        all = new SourceMetrics(allSources());
        packages = PackageGraph.read(PackageGraph.compiledClasses());
    }

    @Test
    void everySourceFileObeysTheRulesOfItsPackage() throws IOException {
        List<String> problems = new ArrayList<>();
        for (Path file : sources()) {
            problems.addAll(
                    LayerRules.violations(ROOT.relativize(file).toString().replace('\\', '/'), Files.readString(file)));
        }
        assertEquals(List.of(), problems);
    }

    @Test
    void everyPackageHasADescription() throws IOException {
        List<Path> silent = sources().stream()
                .map(Path::getParent)
                .distinct()
                .filter(folder -> Files.notExists(folder.resolve("package-info.java")))
                .toList();
        assertEquals(List.of(), silent);
    }

    @Test
    void compiledClassesUseOnlyPackagesBeforeTheirOwn() {
        assertTrue(packages.size() > 25, "jdeps found few packages: " + packages.keySet());
        List<String> upward = new ArrayList<>();
        packages.forEach((user, used) -> used.stream()
                .filter(other -> LayerRules.PACKAGE_ORDER.indexOf(other) > LayerRules.PACKAGE_ORDER.indexOf(user))
                .forEach(other -> upward.add(user + " uses " + other)));
        assertEquals(List.of(), upward);
    }

    @Test
    void noPackageIsPartOfACycle() {
        assertEquals(List.of(), PackageGraph.cycle(packages));
    }

    @Test
    void aCycleIsFound() {
        Map<String, Set<String>> uses =
                Map.of("a", Set.of("b", "d"), "b", Set.of("c"), "c", Set.of("d", "b"), "d", Set.of());
        assertEquals(Set.of("b", "c"), Set.copyOf(PackageGraph.cycle(uses)));
    }

    @Test
    void noPackageIsLarge() throws IOException {
        Map<Path, Long> sizes =
                sources().stream().collect(Collectors.groupingBy(Path::getParent, Collectors.counting()));
        sizes.values().removeIf(size -> size <= MAX_FILES_PER_PACKAGE);
        assertEquals(Map.of(), sizes);
    }

    @Test
    void everySimpleNameIsThatOfOneType() throws IOException {
        Map<String, Long> types = typeNames().collect(Collectors.groupingBy(name -> name, Collectors.counting()));
        assertTrue(types.size() > 800, "few types are where this test looks: " + types.size());
        types.values().removeIf(count -> count == 1);
        assertEquals(Map.of(), types);
    }

    @ParameterizedTest
    @ValueSource(strings = {"java.lang", "java.util", "java.util.function", "java.io", "java.nio.file"})
    void noTypeHidesOneOfTheJdkInDailyUse(String packageName) throws IOException {
        List<String> hidden =
                typeNames().filter(name -> exists(packageName + "." + name)).toList();
        assertEquals(List.of(), hidden);
    }

    /** Returns the simple names of all types that have one, also nested ones. */
    private static Stream<String> typeNames() throws IOException {
        try (Stream<Path> files = Files.walk(PackageGraph.compiledClasses())) {
            return files
                    .map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".class") && !name.matches(".*\\$\\d.*|.*-info.class"))
                    .map(name -> name.replaceFirst("\\.class$", "").replaceFirst(".*\\$", ""))
                    .toList()
                    .stream();
        }
    }

    private static boolean exists(String type) {
        try {
            Class.forName(type, false, FloorsTest.class.getClassLoader());
            return true;
        } catch (ClassNotFoundException none) {
            return false;
        }
    }

    @Test
    void noMethodIsLong() throws IOException {
        assertEquals(List.of(), all.longMethods(MAX_METHOD_LINES));
    }

    @Test
    void noLineIsLong() throws IOException {
        List<String> found = new ArrayList<>();
        for (Path file : allSources()) {
            SourceMetrics.longLines(Files.readString(file), MAX_LINE_LENGTH)
                    .forEach(number -> found.add(file + ":" + number));
        }
        assertEquals(List.of(), found);
    }

    @Test
    void aLongMethodIsFound(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("Long.java");
        Files.writeString(file, "class Long {\n    void f() {" + "\n        f();".repeat(3) + "\n    }\n}\n");
        assertEquals(List.of(file + ":2 f: 5"), new SourceMetrics(List.of(file)).longMethods(4));
        assertEquals(List.of(), new SourceMetrics(List.of(file)).longMethods(5));
    }

    @Test
    void aLongLineIsFoundOutsideTextBlocks() {
        assertEquals(List.of(2, 6), SourceMetrics.longLines("1234\n12345\n\"\"\"\n12345\n\"\"\"\n12345", 4));
    }

    @Test
    void noTextDependsOnTheLanguageOfTheMachine() throws IOException {
        List<String> calls = all.localizedCalls().stream()
                .filter(call -> call.startsWith(ROOT.toString()))
                .toList();
        assertEquals(List.of(), calls);
    }

    @Test
    void aTextThatDependsOnTheLanguageOfTheMachineIsFound(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("Text.java");
        Files.writeString(
                file,
                """
                class Text {
                    String a = String.format("%d", 1);
                    String b = String.format(Locale.ROOT, "%d", 1);
                    String c = "%d".formatted(1);
                    String d = a.toLowerCase();
                    String e = a.toLowerCase(Locale.ROOT);
                }
                """);
        assertEquals(
                List.of(file + ":2 format", file + ":4 formatted", file + ":5 toLowerCase"),
                new SourceMetrics(List.of(file)).localizedCalls());
    }

    @Test
    void typesAreImported() throws IOException {
        assertEquals(List.of(), all.qualifiedTypes());
    }

    @Test
    void aTypeThatIsNotImportedIsFound(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("Named.java");
        Files.writeString(
                file,
                "package faultline.io;\nimport java.util.List;\nclass Named {\n    java.util.Map.Entry<?, ?> e;\n}\n");
        assertEquals(List.of(file + ":4 java.util.Map"), new SourceMetrics(List.of(file)).qualifiedTypes());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            world/World.java         | import faultline.engine.Simulation;          | may not use faultline.engine
            geometry/Pose.java       | import faultline.engine.session.Session; | may not use faultline.engine.session
            world/deep/World.java    | class World {}                          | is in no declared package
            gui/panel/SensorRow.java | import faultline.gui.window.MainWindow; | may not use faultline.gui.window
            geometry/Vector2.java        | faultline.world.World w = null;         | may not use faultline.world
            control/Controller.java  | import faultline.world.World;           | may not use faultline.world
            sensor/Cone.java         | import static faultline.robot.Body.of;  | may not use faultline.robot
            gui/window/MainWindow.java          | import faultline.app.Main;              | may not use faultline.app
            robot/Body.java          | import faultline.util.Strings;          | may not use faultline.util
            util/Strings.java        | class Strings {}                        | is in no declared package
            Loose.java               | class Loose {}                          | is in no declared package
            paint/scene/ScenePainter.java       | import javax.swing.JComponent;          | may not use javax.swing
            gui/change/Rename.java | import javax.swing.JComponent;          | may not use javax.swing
            engine/session/Session.java      | import java.awt.event.ActionEvent;      | may not use java.awt.event
            engine/Simulation.java   | long t = System.nanoTime();             | may not use System.nanoTime
            control/Follower.java    | Thread.sleep(1);                        | may not use Thread.sleep
            world/World.java         | double s = Math.sin(x);                 | may not use Math.sin
            robot/Drive.java         | import static java.lang.Math.sin;       | may not use import static java.lang.Math
            sensor/SensorRandom.java         | import java.util.Random;                | may not use Random
            gui/window/RunPoller.java | import faultline.engine.session.Session; | may not use engine.session.Session
            engine/Clock.java        | double u = Math.random();               | may not use Math.random
            """)
    void aViolationIsReported(String path, String line, String problem) {
        assertEquals(List.of(path + " " + problem), LayerRules.violations(path, line));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            engine/Simulation.java   | import faultline.world.World;
            control/Controller.java  | import faultline.robot.RobotSpec;
            world/World.java         | double s = StrictMath.sin(x) + Math.sqrt(x);
            world/World.java         | // import faultline.engine.Simulation;
            world/World.java         | /** See {@link faultline.engine.Setup}. */
            scenario/Names.java      | String s = "see faultline.app.Main // no comment";
            engine/session/Pacer.java    | long t = System.nanoTime();
            gui/window/MainWindow.java          | import javax.swing.JFrame;
            gui/window/RunPoller.java | import faultline.engine.session.SessionView;
            gui/document/Workspace.java | import faultline.engine.session.Session;
            """)
    void allowedCodePasses(String path, String line) {
        assertEquals(List.of(), LayerRules.violations(path, line));
    }

    private static List<Path> allSources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src"))) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(ROOT)) {
            List<Path> sources = files.filter(file -> file.toString().endsWith(".java"))
                    .sorted()
                    .toList();
            assertTrue(sources.size() > 50, "the sources are not where this test looks: " + ROOT.toAbsolutePath());
            return sources;
        }
    }
}
