package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.ControllerProviders;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.gui.text.Translations;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.List;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Jars are read when a run starts, and may be replaced during the run. */
class JarControllerSourceTest {

    private static final String SERVICE = "META-INF/services/" + ControllerProvider.class.getName();

    /** A controller that loads another class and a resource at its third decision. */
    private static final String LATE =
            """
            package late;
            import faultline.control.*;
            import faultline.robot.Velocity;
            import java.util.Map;
            public final class Late implements ControllerProvider {
                public String name() { return "late"; }
                public Controller create(Map<String, String> settings) { return new Driver(); }
                static final class Driver implements Controller {
                    private int decisions;
                    public Decision decide(Observation seen) {
                        String state = ++decisions < 3 ? "EARLY" : Later.state();
                        return Decision.ofVelocity(seen.robot(), new Velocity(0.1, 0), state, "");
                    }
                }
            }
            """;

    private static final String LATER =
            """
            package late;
            final class Later {
                static String state() {
                    try (var in = Later.class.getResourceAsStream("/state.txt")) {
                        return new String(in.readAllBytes());
                    } catch (java.io.IOException broken) {
                        throw new java.io.UncheckedIOException(broken);
                    }
                }
            }
            """;

    @TempDir
    private Path folder;

    private Path jar(String provider) throws IOException {
        return jar("turner.jar", new Manifest(), Map.of(SERVICE, bytes(provider)));
    }

    private Path jar(String name, Manifest manifest, Map<String, byte[]> files) throws IOException {
        Path jar = folder.resolve(name);
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar), manifest)) {
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                out.putNextEntry(new JarEntry(file.getKey()));
                out.write(file.getValue());
            }
        }
        return jar;
    }

    /** Makes the jar of {@link #LATE}, and that of {@link #LATER}, which its manifest names. */
    private Path lateJar() throws Exception {
        Path classes = compileLate();
        Map<String, byte[]> library = Map.of(
                "late/Later.class", Files.readAllBytes(classes.resolve("Later.class")), "state.txt", bytes("LATER"));
        jar("later.jar", new Manifest(), library);
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes()
                .put(Attributes.Name.CLASS_PATH, "missing.jar no.txt C:\\\\x.jar %zz http://x/y.jar later.jar");
        Files.writeString(folder.resolve("no.txt"), "no jar");
        Map<String, byte[]> files = Map.of(
                SERVICE,
                bytes("late.Late"),
                "late/Late.class",
                Files.readAllBytes(classes.resolve("Late.class")),
                "late/Late$Driver.class",
                Files.readAllBytes(classes.resolve("Late$Driver.class")));
        return jar("late.jar", manifest, files);
    }

    /** Compiles {@link #LATE} and {@link #LATER}, and returns the folder of their classes. */
    private Path compileLate() throws Exception {
        Path sources = Files.createDirectories(folder.resolve("late"));
        String late = Files.writeString(sources.resolve("Late.java"), LATE).toString();
        String later = Files.writeString(sources.resolve("Later.java"), LATER).toString();
        CodeSource program = ControllerProvider.class.getProtectionDomain().getCodeSource();
        String classPath = Path.of(program.getLocation().toURI()).toString();
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-cp", classPath, late, later));
        return sources;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static SimulationSetup setupWith(Path jar, String controller) throws Exception {
        SimulationSetup yard = Scenario.loadShipped("yard.xml").setup().withDuration(0.1);
        return new ControllerChoice(controller, List.of(jar)).applyTo(yard, null);
    }

    @Test
    void jarsThatAreReplacedDuringARunHaveNoEffectOnIt() throws Exception {
        Path jar = lateJar();
        SimulationSetup setup = setupWith(jar, "late");
        try (Simulation run = new Simulation(setup, ControllerMode.DIRECT)) {
            run.tick();
            run.tick();
            assertEquals("EARLY", run.telemetry().state().name());
            for (String name : List.of("late.jar", "later.jar")) {
                Files.writeString(folder.resolve(name), "no jar");
            }
            run.tick();
            assertEquals("LATER", run.telemetry().state().name());
        }
        String broken = assertThrows(ControllerStartException.class, () -> new Simulation(setup, ControllerMode.DIRECT))
                .getMessage();
        assertTrue(broken.startsWith("the jar " + jar + " cannot be read: "), broken);
        Files.delete(jar);
        assertEquals(
                "there is no jar " + jar,
                assertThrows(ControllerStartException.class, () -> new Simulation(setup, ControllerMode.DIRECT))
                        .getMessage());
    }

    @Test
    void aJarThatIsAskedForMustBeReadableThoughAnotherNamesIt() throws Exception {
        List<Path> jars = List.of(lateJar(), folder.resolve("no.txt"));
        String broken = assertThrows(
                        ControllerStartException.class, () -> ControllerJars.callWith(jars, ControllerNames::all))
                .getMessage();
        assertTrue(broken.startsWith("the jar " + folder.resolve("no.txt") + " cannot be read: "), broken);
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "the open files are listed in /proc")
    void aJarIsNotOpenDuringItsRun() throws Exception {
        Path jar = jar(RightTurner.class.getName());
        try (Simulation run = new Simulation(setupWith(jar, "right-turner"), ControllerMode.DIRECT)) {
            run.tick();
            try (Stream<Path> open = Files.list(Path.of("/proc/self/fd"))) {
                assertTrue(open.noneMatch(link -> leadsTo(link, jar)));
            }
        }
    }

    private static boolean leadsTo(Path link, Path file) {
        try {
            return Files.readSymbolicLink(link).equals(file);
        } catch (IOException closed) {
            return false;
        }
    }

    @Test
    void eachRunLoadsTheJarAsItIsWhenItStarts() throws Exception {
        SimulationSetup setup = setupWith(jar(RightTurner.class.getName()), "right-turner");
        try (Simulation run = new Simulation(setup, ControllerMode.DIRECT)) {
            assertEquals("right-turner", run.controllerName());
        }
        jar("no.such.Turner");
        assertThrows(RunFailedException.class, () -> new Simulation(setup, ControllerMode.DIRECT));
    }

    @Test
    void aControllerFromAJarHasTheSettingsOfAFileThatNamesIt() throws Exception {
        List<Path> jars = List.of(jar(RightTurner.class.getName()));
        ControllerSpec named = new ControllerSpec.Provided("right-turner", 0, Map.of("volts", "2"));
        SimulationSetup setup = Scenario.loadShipped("yard.xml").setup().withController(named);
        assertEquals(
                new ControllerSpec.Chosen(named, new JarControllerSource("right-turner", jars, Map.of("volts", "2"))),
                new ControllerChoice("right-turner", jars).applyTo(setup, null).controller());
    }

    @Test
    void theNamesInAJarAreFound() throws Exception {
        List<String> names = ControllerJars.callWith(List.of(jar(RightTurner.class.getName())), ControllerNames::all);
        assertTrue(names.contains("right-turner"), names::toString);
    }

    @Test
    void aControllerComesFromItsJar() throws Exception {
        Path jar = lateJar();
        assertEquals(
                jar,
                ControllerJars.callWith(List.of(jar), ControllerProviders::jars).get("late"));
    }

    @Test
    void aJarThatNamesNoControllerIsRefusedWithTheFileThatItNeeds() throws Exception {
        Path jar = jar("none.jar", new Manifest(), Map.of("late/Late.class", bytes("any")));
        assertRefused(
                "the jar " + jar + " has no controller, because it has no file " + SERVICE
                        + ", which contains the full name of the controller's class",
                List.of(jar(RightTurner.class.getName()), jar));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "\n# late.Late\n", "java.lang.String"})
    void aJarWhoseFileNamesNoClassOfAControllerIsRefused(String file) throws IOException {
        Path jar = jar(file);
        assertRefused(
                "the jar " + jar + " has no controller, because its file " + SERVICE
                        + " names no class of one; expected the full name of the controller's class",
                List.of(jar));
    }

    @Test
    void aClassThatAJarLacksIsNamed() throws IOException {
        assertRefused(
                "a controller in Java cannot be loaded: there is no class WallBot, which a file " + SERVICE
                        + " names; expected the full name of a class",
                List.of(jar("WallBot")));
    }

    /** A provider that only this class may create. */
    private static class HiddenProvider implements ControllerProvider {
        @Override
        public String name() {
            return "hidden";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** Another one, with a constructor that would be public in a public class. */
    private static final class OpenHiddenProvider extends HiddenProvider {

        /** Creates the provider. */
        public OpenHiddenProvider() {}
    }

    /** A provider that needs a value. */
    public static final class ArgumentProvider extends HiddenProvider {

        /**
         * Creates the provider.
         *
         * @param argument any
         */
        public ArgumentProvider(int argument) {
            assertEquals(0, argument);
        }
    }

    /** A provider that is not complete. */
    public abstract static class AbstractProvider implements ControllerProvider {}

    @Test
    void aClassThatIsNoProviderIsNamed() throws IOException {
        String name = JarControllerSourceTest.class.getName();
        assertRefused(
                "a controller in Java cannot be loaded: the class " + name + ", which a file " + SERVICE
                        + " names, does not implement " + ControllerProvider.class.getName(),
                List.of(jar(name)));
    }

    @ParameterizedTest
    @ValueSource(classes = {HiddenProvider.class, OpenHiddenProvider.class, ArgumentProvider.class})
    void aClassThatMustNotBeCreatedIsNamedWithTheRule(Class<?> provider) throws IOException {
        assertRefused(
                "a controller in Java cannot be loaded: the class " + provider.getName()
                        + " is not public, or has no public constructor without parameters",
                List.of(jar(provider.getName())));
    }

    @Test
    void anAbstractClassIsNamed() throws IOException {
        assertRefused(
                "a controller in Java cannot be loaded: the class " + AbstractProvider.class.getName() + " is abstract",
                List.of(jar(AbstractProvider.class.getName())));
    }

    @Test
    void aClassForALaterJavaIsRefusedWithTheVersions() throws Exception {
        byte[] late = Files.readAllBytes(compileLate().resolve("Late.class"));
        // The version of a class file is in its bytes 6 and 7.
        late[6] = 0;
        late[7] = 44 + 80;
        Path jar = jar("new.jar", new Manifest(), Map.of(SERVICE, bytes("late.Late"), "late/Late.class", late));
        int version = Runtime.version().feature();
        assertRefused(
                "a controller in Java cannot be loaded: late.Late was compiled for Java 80, but Java " + version
                        + " runs it; compile it with --release " + version,
                List.of(jar));
    }

    @Test
    void aJarMayBeNamedAgain() throws Exception {
        Path jar = jar("turner.jar", new Manifest(), Map.of(SERVICE, bytes(RightTurner.class.getName())));
        List<String> names = ControllerJars.callWith(List.of(jar, jar), ControllerNames::all);
        assertTrue(names.contains("right-turner"), names::toString);
    }

    private static void assertRefused(String sentence, List<Path> jars) {
        RunFailedException refusal =
                assertThrows(RunFailedException.class, () -> ControllerJars.callWith(jars, ControllerNames::all));
        assertEquals(sentence, refusal.getMessage());
        Translations.assertTranslated(refusal.reason());
    }

    /** A provider whose constructor fails. */
    public static final class UnfinishedProvider implements ControllerProvider {

        /** Fails. */
        public UnfinishedProvider() {
            throw new IllegalStateException("no map");
        }

        @Override
        public String name() {
            return "unfinished";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError();
        }
    }

    @Test
    void aConstructorThatFailsIsReportedWithItsException() throws IOException {
        Path jar = jar(UnfinishedProvider.class.getName());
        RunFailedException failure = assertThrows(
                RunFailedException.class, () -> ControllerJars.callWith(List.of(jar), ControllerNames::all));
        assertTrue(
                failure.getMessage().endsWith(" could not be instantiated: java.lang.IllegalStateException: no map"),
                failure.getMessage());
    }
}
