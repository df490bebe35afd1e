package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.external.ControllerChoice;
import faultline.external.ExternalController;
import faultline.external.ProcessControllerSource;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ControllerRunnerTest {

    private static final AtomicInteger PROVIDERS = new AtomicInteger();

    @TempDir
    private Path folder;

    /** Counts the times that the jar is searched for controllers. */
    public static final class CountedProvider implements ControllerProvider {

        /** Called by the service loader. */
        public CountedProvider() {
            PROVIDERS.incrementAndGet();
        }

        @Override
        public String name() {
            return "counted";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            return observation -> new Decision(1, 1, Telemetry.ofState(ControllerState.of("GO")));
        }
    }

    private Path jar() throws IOException {
        Path jar = folder.resolve("counted.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("META-INF/services/" + ControllerProvider.class.getName()));
            out.write(CountedProvider.class.getName().getBytes(StandardCharsets.UTF_8));
        }
        return jar;
    }

    @Test
    void aRunSearchesItsJarsWhenItIsPreparedAndWhenItStarts() throws Exception {
        SimulationSetup setup = Scenario.loadShipped("yard.xml").setup().withDuration(0.1);
        ProcessControllerSource.ChildSettings settings = new ProcessControllerSource.ChildSettings(
                "test", "Yard", ExternalController.Timeouts.DEFAULT, false, line -> {});
        ControllerChoice choice = new ControllerChoice("counted", List.of(jar()));
        PROVIDERS.set(0);
        new ControllerRunner(choice, settings).run(setup, ControllerMode.DIRECT, List.of());
        assertEquals(2, PROVIDERS.get());
    }
}
