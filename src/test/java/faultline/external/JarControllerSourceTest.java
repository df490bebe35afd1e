package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Jars are not open longer than their controllers are used. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "the open files are listed in /proc")
class JarControllerSourceTest {

    @TempDir
    private Path folder;

    private Path jar(String provider) throws IOException {
        Path jar = folder.resolve("turner.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("META-INF/services/" + ControllerProvider.class.getName()));
            out.write(provider.getBytes(StandardCharsets.UTF_8));
        }
        return jar;
    }

    private static SimulationSetup setupWith(Path jar) throws Exception {
        SimulationSetup yard = Scenario.loadShipped("yard.xml").setup().withDuration(0.1);
        return ControllerChoice.apply("right-turner", List.of(jar), yard, null);
    }

    private static boolean isOpen(Path file) throws IOException {
        try (Stream<Path> open = Files.list(Path.of("/proc/self/fd"))) {
            return open.anyMatch(link -> leadsTo(link, file));
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
    void aJarIsOpenDuringItsRunOnly() throws Exception {
        Path jar = jar(RightTurner.class.getName());
        SimulationSetup setup = setupWith(jar);
        assertTrue(!isOpen(jar), "no run has started");
        try (Simulation run = new Simulation(setup, ControllerMode.DIRECT)) {
            run.tick();
            assertEquals("right-turner", run.controllerName());
            assertTrue(isOpen(jar));
        }
        assertTrue(!isOpen(jar), "the run has ended");
        HeadlessRun.run(setup, ControllerMode.DIRECT, List.of());
        assertTrue(!isOpen(jar), "another run of the same setup has ended");
    }

    @Test
    void aJarIsClosedWhenItsNamesAreKnown() throws Exception {
        Path jar = jar(RightTurner.class.getName());
        List<String> names = ControllerChoice.withJars(List.of(jar), ControllerChoice::names);
        assertTrue(names.contains("right-turner"), names::toString);
        assertTrue(!isOpen(jar));
    }

    @Test
    void aJarThatHasBecomeBrokenBreaksTheRunAndIsClosed() throws Exception {
        SimulationSetup setup = setupWith(jar(RightTurner.class.getName()));
        Path broken = jar("no.such.Turner");
        assertThrows(RunFailedException.class, () -> new Simulation(setup, ControllerMode.DIRECT));
        assertTrue(!isOpen(broken));
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
                RunFailedException.class, () -> ControllerChoice.withJars(List.of(jar), ControllerChoice::names));
        assertTrue(
                failure.getMessage().endsWith(" could not be instantiated: java.lang.IllegalStateException: no map"),
                failure.getMessage());
    }
}
