package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.external.ControllerChoice;
import faultline.external.ExternalController;
import faultline.external.ProcessControllerSource;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ControllerRunnerTest {

    private static final AtomicInteger PROVIDERS = new AtomicInteger();
    private static final ProcessControllerSource.ChildSettings SETTINGS = new ProcessControllerSource.ChildSettings(
            "test", "Yard", ExternalController.Timeouts.DEFAULT, false, line -> {});

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

    private int recordedDecisions(String... arguments) throws Exception {
        List<String> run = new ArrayList<>(List.of("scenarios/yard.xml"));
        run.addAll(List.of(arguments));
        AtomicInteger decisions = new AtomicInteger();
        try (RunOutputs outputs = new RunOutputs(RunOptions.parse(run))) {
            List<TickObserver> observers = new ArrayList<>(outputs.observers());
            observers.add(
                    simulation -> decisions.set(simulation.journal().decisions().size()));
            new ControllerRunner(new ControllerChoice("counted", List.of(jar())), SETTINGS)
                    .run(Scenario.loadShipped("yard.xml").setup().withDuration(0.1), ControllerMode.DIRECT, observers);
        }
        return decisions.get();
    }

    /** They fill the memory in a long run with a controller that changes the volts in every tick. */
    @Test
    void theDecisionsOfARunAreRecordedOnlyForItsJournal() throws Exception {
        assertEquals(0, recordedDecisions());
        assertEquals(0, recordedDecisions("--image", folder.resolve("a.png").toString()));
        assertEquals(1, recordedDecisions("--journal", folder.resolve("a.xml").toString()));
    }

    @Test
    void aRunSearchesItsJarsWhenItIsPreparedAndWhenItStarts() throws Exception {
        SimulationSetup setup = Scenario.loadShipped("yard.xml").setup().withDuration(0.1);
        ControllerChoice choice = new ControllerChoice("counted", List.of(jar()));
        PROVIDERS.set(0);
        new ControllerRunner(choice, SETTINGS).run(setup, ControllerMode.DIRECT, List.of());
        assertEquals(2, PROVIDERS.get());
    }
}
