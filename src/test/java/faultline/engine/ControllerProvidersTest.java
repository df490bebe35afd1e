package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.scenario.Scenario;
import faultline.world.WorldSpec;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

/** Providers that break the contract of their interface are named, and are not taken for a defect of the program. */
class ControllerProvidersTest {

    @TempDir
    private Path folder;

    private final ClassLoader before = Thread.currentThread().getContextClassLoader();

    @AfterEach
    void removeProvider() {
        Thread.currentThread().setContextClassLoader(before);
    }

    private void addProvider(Class<?>... providers) throws Exception {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        List<String> names = Arrays.stream(providers).map(Class::getName).toList();
        Files.write(services.resolve(ControllerProvider.class.getName()), names);
        Thread.currentThread()
                .setContextClassLoader(
                        new URLClassLoader(new URL[] {folder.toUri().toURL()}, before));
    }

    /** A provider whose name is null. */
    public static final class Nameless implements ControllerProvider {
        @Override
        public String name() {
            return null;
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** A provider that fails when it is asked for its name. */
    public static final class Failing implements ControllerProvider {
        @Override
        public String name() {
            throw new IllegalStateException("not today");
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** A provider that makes no controller, or one that makes no decision. */
    public static final class Empty implements ControllerProvider {
        @Override
        public String name() {
            return "empty";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            return settings.isEmpty() ? null : observation -> null;
        }
    }

    /** Another provider with the same name. */
    public static final class OtherEmpty implements ControllerProvider {
        @Override
        public String name() {
            return "empty";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** A provider with the name of a built-in controller. */
    public static final class Usurper implements ControllerProvider {
        @Override
        public String name() {
            return "wall-follower";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** A provider that leaves its thread interrupted. */
    public static final class Interrupting implements ControllerProvider {
        @Override
        public String name() {
            return "interrupting";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            Thread.currentThread().interrupt();
            return ControllerFactory.create(new ControllerSpec.None());
        }
    }

    static void waitForEver() {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException ended) {
            throw new IllegalStateException(ended);
        }
    }

    /** A provider whose constructor does not return. */
    public static final class EndlessConstructor implements ControllerProvider {

        /** Does not return. */
        public EndlessConstructor() {
            waitForEver();
        }

        @Override
        public String name() {
            throw new AssertionError("nobody can ask for it");
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** A provider that does not say its name. */
    public static final class EndlessName implements ControllerProvider {
        @Override
        public String name() {
            waitForEver();
            return "late";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("nobody can ask for it");
        }
    }

    /** A provider of controllers whose {@code close} does what a setting says, or none if there is no setting. */
    public static class EndlessClose implements ControllerProvider {

        private record Closing(String how) implements Controller, AutoCloseable {
            @Override
            public Decision decide(Observation observation) {
                return new Decision(1, 1, Telemetry.ofState(ControllerState.of("TEST")));
            }

            @Override
            public void close() {
                if (how.equals("never")) {
                    waitForEver();
                } else if (how.equals("unspeakable")) {
                    throw new ControllerHostTest.Unspeakable();
                } else if (how.equals("endless")) {
                    throw new ControllerHostTest.Endless();
                }
                AssertionError error = new AssertionError(how);
                error.setStackTrace(
                        new StackTraceElement[] {new StackTraceElement("own.WallBot", "close", "WallBot.java", 8)});
                throw error;
            }
        }

        @Override
        public String name() {
            return "endless-close";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            if (settings.isEmpty()) {
                waitForEver();
            }
            return new Closing(settings.get("close"));
        }
    }

    private static RunResult run(String name, Map<String, String> settings) {
        WorldSpec room = new WorldSpec(4, 3, true, 3, List.of());
        SimulationSetup setup = SimulationSetup.of(room, new Pose(2, 1.5, 0))
                .withDuration(1)
                .withController(new ControllerSpec.Provided(name, 0, settings));
        return HeadlessRun.run(setup, ControllerMode.DIRECT, List.of());
    }

    private static String failure(Map<String, String> settings) {
        return assertThrows(RunFailedException.class, () -> run("empty", settings))
                .getMessage();
    }

    @Test
    void aProviderThatInterruptsItsThreadEndsNoRun() throws Exception {
        addProvider(Interrupting.class);
        assertEquals(100, run("interrupting", Map.of()).ticks());
        assertFalse(Thread.interrupted());
    }

    /** A campaign that is cancelled interrupts its threads. */
    @Test
    void anInterruptionFromBeforeTheCreationStays() throws Exception {
        addProvider(Interrupting.class);
        Thread.currentThread().interrupt();
        ControllerProviders.create("interrupting", Map.of());
        assertTrue(Thread.interrupted());
    }

    @Test
    void aProviderWithoutANameIsNamedByItsClass() throws Exception {
        addProvider(Nameless.class);
        RunFailedException refusal = assertThrows(RunFailedException.class, ControllerProviders::names);
        assertEquals(
                "the controller in Java " + Nameless.class.getName() + " has no name: name returned null",
                refusal.getMessage());
        addProvider(Failing.class);
        refusal = assertThrows(RunFailedException.class, () -> ControllerProviders.find("any"));
        assertEquals(
                "the controller in Java " + Failing.class.getName()
                        + " has no name: java.lang.IllegalStateException: not today",
                refusal.getMessage());
    }

    @Test
    void theNameOfABuiltInControllerIsRefused() throws Exception {
        addProvider(Usurper.class);
        RunFailedException refusal = assertThrows(RunFailedException.class, ControllerProviders::names);
        assertEquals(
                "the controller in Java " + Usurper.class.getName() + " has the name of a built-in one: wall-follower",
                refusal.getMessage());
    }

    @Test
    void twoControllersWithTheSameNameAreRefused() throws Exception {
        addProvider(Empty.class, OtherEmpty.class);
        RunFailedException refusal = assertThrows(RunFailedException.class, () -> ControllerProviders.find("empty"));
        assertEquals(
                "the controllers in Java " + Empty.class.getName() + " and " + OtherEmpty.class.getName()
                        + " have the same name: empty",
                refusal.getMessage());
    }

    @Test
    void aMissingControllerOrDecisionIsSaidInWords() throws Exception {
        addProvider(Empty.class);
        assertEquals(
                "the controller \"empty\" cannot be created: java.lang.NullPointerException: create returned null",
                failure(Map.of()));
        assertEquals(
                "the controller broke at tick 0: java.lang.NullPointerException: decide returned null",
                failure(Map.of("decision", "none")));
    }

    /** A provider that counts its instances. */
    public static final class Counted implements ControllerProvider {

        private static final AtomicInteger INSTANCES = new AtomicInteger();

        /** Counts this instance. */
        public Counted() {
            INSTANCES.incrementAndGet();
        }

        @Override
        public String name() {
            return "counted";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            return ControllerFactory.create(new ControllerSpec.None());
        }
    }

    /** One for the name, however many scenarios are read, and one for each run, so that runs share no provider. */
    @Test
    void aProviderIsMadeOnceForItsNameAndOnceForEachRun() throws Exception {
        addProvider(Counted.class);
        Path file = folder.resolve("counted.xml");
        Scenario yard = Scenario.loadShipped("yard.xml");
        ControllerSpec counted = new ControllerSpec.Provided("counted", 0, Map.of());
        yard.withSetup(yard.setup().withController(counted)).save(file);
        for (int i = 0; i < 3; i++) {
            Scenario.load(file);
        }
        assertEquals(List.of("counted"), ControllerProviders.names());
        assertEquals(1, Counted.INSTANCES.get());
        run("counted", Map.of());
        run("counted", Map.of());
        assertEquals(3, Counted.INSTANCES.get());
    }

    /** A provider whose class cannot be initialised. */
    public static final class BrokenClass implements ControllerProvider {

        private static final int NUMBER = Integer.parseInt("none");

        @Override
        public String name() {
            return "broken-" + NUMBER;
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("there is no instance");
        }
    }

    @Test
    void theReasonWhyAClassCannotBeInitialisedIsNamed() throws Exception {
        addProvider(BrokenClass.class);
        String refusal = assertThrows(RunFailedException.class, ControllerProviders::names)
                .getMessage();
        assertTrue(refusal.endsWith(": java.lang.NumberFormatException: For input string: \"none\""), refusal);
    }

    @Test
    void aProviderThatDoesNotAnswerIsAnErrorAfterTheTimeOfADecision() throws Exception {
        addProvider(EndlessConstructor.class);
        assertFails(
                "a controller in Java cannot be loaded: the constructor of " + EndlessConstructor.class.getName()
                        + " has not returned for 0.05 s",
                () -> ControllerProviders.all(0.05));
        addProvider(EndlessName.class);
        assertFails(
                "the controller in Java " + EndlessName.class.getName()
                        + " has no name: name has not returned for 0.05 s",
                () -> ControllerProviders.all(0.05));
        assertFails(
                "the controller \"endless-close\" cannot be created: create has not returned for 0.05 s",
                () -> ControllerProviders.create("endless-close", new EndlessClose(), Map.of(), 0.05));
    }

    private static void assertFails(String sentence, Executable action) {
        assertEquals(sentence, assertThrows(RunFailedException.class, action).getMessage());
        assertFalse(Thread.interrupted());
    }

    @Test
    void aControllerThatDoesNotReturnFromCloseIsAnErrorAfterTheTimeOfADecision() throws Exception {
        addProvider(EndlessClose.class);
        ControllerSpec spec = new ControllerSpec.Provided("endless-close", 0, Map.of("close", "never"));
        Controller controller = ControllerFactory.create(spec);
        assertFails(
                "the controller cannot be closed: close has not returned for 0.05 s",
                () -> ControllerFactory.close(controller, spec, 0.05));
    }

    @Test
    void anErrorOfCloseEndsTheRunAsAnExceptionDoes() throws Exception {
        addProvider(EndlessClose.class);
        assertFails(
                "the controller cannot be closed: java.lang.AssertionError: at the end"
                        + " at own.WallBot.close(WallBot.java:8)",
                () -> run("endless-close", Map.of("close", "at the end")));
    }

    /** A provider whose exceptions cannot be read. */
    public static final class Unspeaking implements ControllerProvider {
        @Override
        public String name() {
            throw new ControllerHostTest.Unspeakable();
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new ControllerHostTest.Unspeakable();
        }
    }

    @Test
    void anExceptionThatCannotBeReadIsNamedByItsClass() throws Exception {
        String unread = ControllerHostTest.Unspeakable.class.getName() + ", whose text cannot be read";
        addProvider(Unspeaking.class);
        assertFails(
                "the controller in Java " + Unspeaking.class.getName() + " has no name: " + unread,
                ControllerProviders::names);
        assertFails(
                "the controller \"any\" cannot be created: " + unread,
                () -> ControllerProviders.create("any", new Unspeaking(), Map.of()));
        addProvider(EndlessClose.class);
        assertFails(
                "the controller cannot be closed: " + unread,
                () -> run("endless-close", Map.of("close", "unspeakable")));
    }

    /** A provider whose exceptions have a text that takes for ever. */
    public static final class EndlessText implements ControllerProvider {
        /** As the service loader needs it. */
        public EndlessText() {
            throw new ControllerHostTest.Endless();
        }

        @Override
        public String name() {
            throw new AssertionError("there is no instance");
        }

        @Override
        public Controller create(Map<String, String> settings) {
            throw new AssertionError("there is no instance");
        }
    }

    @Test
    @Timeout(value = 1, unit = TimeUnit.MINUTES)
    void anExceptionWhoseTextTakesForEverIsACallThatDoesNotReturn() throws Exception {
        addProvider(EndlessText.class);
        assertFails(
                "a controller in Java cannot be loaded: the constructor of " + EndlessText.class.getName()
                        + " has not returned for 0.05 s",
                () -> ControllerProviders.all(0.05));
        addProvider(EndlessClose.class);
        ControllerSpec spec = new ControllerSpec.Provided("endless-close", 0, Map.of("close", "endless"));
        Controller controller = ControllerFactory.create(spec);
        assertFails(
                "the controller cannot be closed: close has not returned for 0.05 s",
                () -> ControllerFactory.close(controller, spec, 0.05));
    }

    @Test
    void anInterruptionEndsTheWaitForAProvider() {
        Thread waiting = Thread.currentThread();
        ControllerProvider interrupting = new EndlessClose() {
            @Override
            public Controller create(Map<String, String> settings) {
                waiting.interrupt();
                return super.create(settings);
            }
        };
        RunFailedException end =
                assertThrows(RunFailedException.class, () -> ControllerProviders.create("any", interrupting, Map.of()));
        assertEquals("the run was interrupted at tick 0", end.getMessage());
        assertTrue(Thread.interrupted());
    }
}
