package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.gui.text.Translations;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Controllers in Java and in child processes: chosen, recorded, and replayed without them. */
@Timeout(120)
class ForeignControllerTest {

    @TempDir
    private Path folder;

    private final ClassLoader before = Thread.currentThread().getContextClassLoader();

    @BeforeEach
    void addProvider() throws Exception {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(services.resolve(ControllerProvider.class.getName()), RightTurner.class.getName());
        Thread.currentThread()
                .setContextClassLoader(
                        new URLClassLoader(new URL[] {folder.toUri().toURL()}, before));
    }

    @AfterEach
    void removeProvider() {
        Thread.currentThread().setContextClassLoader(before);
    }

    private static Scenario yard() throws ScenarioException {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        return yard.withSetup(yard.setup().withDuration(30));
    }

    /** A run and the scenario that replays it. */
    private record Recorded(RunResult result, Scenario replay) {}

    private static Recorded record(Scenario scenario, SimulationSetup setup) {
        AtomicReference<Journal> journal = new AtomicReference<>();
        TickObserver last = simulation -> {
            if (simulation.ticks() == setup.ticks()) {
                journal.set(simulation.journal());
            }
        };
        RunResult result = HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(last));
        return new Recorded(result, JournalScenario.create(scenario, journal.get()));
    }

    private void assertReplays(Recorded recorded) throws Exception {
        Path file = folder.resolve("journal.xml");
        recorded.replay().save(file);
        Thread.currentThread().setContextClassLoader(before);
        Scenario loaded = Scenario.load(file);
        assertEquals(recorded.replay(), loaded);
        RunResult replayed = HeadlessRun.run(loaded.setup(), ControllerMode.OWN_THREAD, List.of());
        assertEquals(recorded.result().trajectoryHash(), replayed.trajectoryHash());
        assertEquals(recorded.result().finalState(), replayed.finalState());
        assertEquals(recorded.result().coverage(), replayed.coverage());
        assertEquals(recorded.result().distanceRms(), replayed.distanceRms());
    }

    @Test
    void aControllerInJavaIsFoundByItsNameAndReplaysWithoutIt() throws Exception {
        SimulationSetup setup = ControllerChoice.of("right-turner").applyTo(yard().setup(), null);
        Recorded recorded = record(yard(), setup);
        assertTrue(recorded.result().visitedStates().contains(ControllerState.of("NEAR")), recorded.result()::toString);
        assertEquals(
                recorded.result().trajectoryHash(),
                HeadlessRun.run(setup, ControllerMode.OWN_THREAD, List.of()).trajectoryHash());
        assertReplays(recorded);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aChildReplaysWithoutIt() throws Exception {
        String child = "sh -c 'read h; echo \"{\\\"type\\\":\\\"ready\\\",\\\"protocol\\\":1}\"; i=0; "
                + "while read l; do case $l in *observe*) echo \"{\\\"type\\\":\\\"drive\\\",\\\"tick\\\":$i,"
                + "\\\"v_m_s\\\":0.2,\\\"omega_rad_s\\\":0.$((i % 7)),\\\"state\\\":\\\"S$((i / 300))\\\"}\";; esac; "
                + "i=$((i+1)); done'";
        ProcessControllerSource.ChildSettings settings = new ProcessControllerSource.ChildSettings(
                "test", "Yard", ExternalController.Timeouts.DEFAULT, false, line -> {});
        SimulationSetup setup = yard().setup().withDuration(9);
        Recorded recorded =
                record(yard(), ControllerChoice.of(child).applyTo(setup, new ProcessControllerSource(child, settings)));
        assertEquals(
                List.of("EXTERN", "S0", "S1", "S2"),
                recorded.result().visitedStates().stream()
                        .map(ControllerState::name)
                        .toList());
        assertReplays(recorded);
    }

    @Test
    void aRunWhoseDecisionsAreNotRecordedIsTheSame() throws Exception {
        SimulationSetup setup = ControllerChoice.of("right-turner").applyTo(yard().setup(), null);
        AtomicReference<Journal> journal = new AtomicReference<>();
        RunResult result = HeadlessRun.run(
                setup,
                ControllerMode.DIRECT,
                List.of(Simulation::stopRecordingDecisions, simulation -> journal.set(simulation.journal())));
        assertEquals(List.of(), journal.get().decisions());
        assertEquals(record(yard(), setup).result().trajectoryHash(), result.trajectoryHash());
    }

    @Test
    void theRecordOfDecisionsIsNotContinued() throws Exception {
        SimulationSetup setup = ControllerChoice.of("right-turner").applyTo(yard().setup(), null);
        SimulationSetup longer = record(yard(), setup).replay().setup().withDuration(30.02);
        RunFailedException e =
                assertThrows(RunFailedException.class, () -> HeadlessRun.run(longer, ControllerMode.DIRECT, List.of()));
        assertEquals("the record of decisions ends after tick 3000", e.getMessage());
        Translations.assertTranslated(e.reason());
    }

    @Test
    void recordedDecisionsWithoutAStateKeepTheLastOne() throws Exception {
        Scenario scenario = Scenario.load(fileWith("<controller type=\"recorded\" ticks=\"3000\">"
                + "<decisions>1,1*10</decisions><decisions from=\"10\" state=\"A\">1,1*10</decisions>"
                + "<decisions from=\"20\">2,2</decisions></controller>"));
        RunResult result = HeadlessRun.run(scenario.setup().withDuration(0.5), ControllerMode.DIRECT, List.of());
        assertEquals(
                List.of(ControllerState.of("EXTERN"), ControllerState.of("A")), List.copyOf(result.visitedStates()));
    }

    @Test
    void aFileNamesAControllerInJavaWithItsSettings() throws Exception {
        Path path = fileWith("<controller type=\"right-turner\" period=\"0.02\" distance=\"0.3\">"
                + "<setting name=\"volts\" value=\"2\"/></controller>");
        Scenario scenario = Scenario.load(path);
        assertEquals(
                new ControllerSpec.Provided("right-turner", 0.02, 0.3, Map.of("volts", "2")),
                scenario.setup().controller());
        scenario.save(path);
        assertEquals(scenario, Scenario.load(path));
        assertEquals(2, firstVolts(scenario.setup()));
    }

    @Test
    void aSettingThatIsGivenTwiceIsReported() throws Exception {
        Path path = fileWith("<controller type=\"right-turner\">\n<setting name=\"volts\" value=\"2\"/>\n"
                + "<setting name=\"volts\" value=\"3\"/></controller>");
        ScenarioException e = assertThrows(ScenarioException.class, () -> Scenario.load(path));
        assertEquals(1, e.problems().size());
        assertTrue(
                e.getMessage()
                        .endsWith(
                                ": name of <setting> is \"volts\", which another <setting> has; expected unique names"),
                e.getMessage());
    }

    /** They are reported for what they lack only. */
    @Test
    void settingsWithoutANameAreNotReportedAsEqual() throws Exception {
        Path path =
                fileWith("<controller type=\"right-turner\"><setting value=\"2\"/><setting value=\"3\"/></controller>");
        ScenarioException e = assertThrows(ScenarioException.class, () -> Scenario.load(path));
        assertEquals(2, e.problems().size(), e.getMessage());
    }

    @Test
    void aChosenControllerHasTheSettingsOfAFileThatNamesIt() throws Exception {
        SimulationSetup named =
                yard().setup().withController(new ControllerSpec.Provided("right-turner", 0, Map.of("volts", "2")));
        SimulationSetup other =
                yard().setup().withController(new ControllerSpec.Provided("other", 0, Map.of("volts", "2")));
        ControllerChoice choice = ControllerChoice.of("right-turner");
        assertEquals(2, firstVolts(choice.applyTo(named, null)));
        assertEquals(firstVolts(choice.applyTo(yard().setup(), null)), firstVolts(choice.applyTo(other, null)));
    }

    private Path fileWith(String controller) throws IOException {
        String yard = Files.readString(Path.of("scenarios/yard.xml"));
        return Files.writeString(folder.resolve("room.xml"), yard.replace("</scenario>", controller + "</scenario>"));
    }

    private static double firstVolts(SimulationSetup setup) {
        AtomicReference<Double> volts = new AtomicReference<>();
        HeadlessRun.run(setup.withDuration(0.01), ControllerMode.DIRECT, List.of(run -> volts.set(run.leftVolts())));
        return volts.get();
    }

    @Test
    void aMisspeltNameOfAFileIsCorrected() throws Exception {
        Path path = fileWith("<controller type=\"right-turnr\"/>");
        ScenarioException e = assertThrows(ScenarioException.class, () -> Scenario.load(path));
        assertTrue(e.getMessage().endsWith("did you mean \"right-turner\"?"), e.getMessage());
    }

    @Test
    void aMisspeltNameOfTheCommandLineIsCorrected() {
        ProcessControllerSource.ChildSettings settings = new ProcessControllerSource.ChildSettings(
                "test", "Yard", ExternalController.Timeouts.DEFAULT, false, line -> {});
        ProcessControllerSource source = new ProcessControllerSource("right-turnr", settings);
        ControllerStartException e = assertThrows(
                ControllerStartException.class,
                () -> HeadlessRun.run(
                        ControllerChoice.of("right-turnr").applyTo(yard().setup(), source),
                        ControllerMode.DIRECT,
                        List.of()));
        assertTrue(e.getMessage().endsWith("did you mean \"right-turner\"?"), e.getMessage());
    }

    @Test
    void anErrorIsReportedInDirectModeAsOnAThread() throws Exception {
        SimulationSetup setup = broken("error");
        for (ControllerMode mode : ControllerMode.values()) {
            RunFailedException e =
                    assertThrows(RunFailedException.class, () -> HeadlessRun.run(setup, mode, List.of()));
            assertEquals(
                    "the controller broke at tick 7: java.lang.StackOverflowError: too deep",
                    e.getMessage(),
                    mode.name());
        }
    }

    @Test
    void aControllerInJavaThatDoesNotAnswerEndsTheRunAndItsThread() throws Exception {
        RunFailedException e = assertThrows(
                RunFailedException.class, () -> HeadlessRun.run(broken("sleep"), ControllerMode.DIRECT, List.of()));
        assertEquals("the controller has not answered for 10.0 s at tick 7", e.getMessage());
        Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("faultline-controller"))
                .forEach(ForeignControllerTest::assertEnds);
    }

    private static void assertEnds(Thread thread) {
        try {
            thread.join(5000);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
        assertTrue(!thread.isAlive(), thread::toString);
    }

    @Test
    void aControllerInJavaIsClosedAtTheEndOfItsRun() throws Exception {
        for (ControllerMode mode : ControllerMode.values()) {
            int before = RightTurner.CLOSED.get();
            HeadlessRun.run(broken(""), mode, List.of());
            assertEquals(before + 1, RightTurner.CLOSED.get(), mode.name());
        }
    }

    @Test
    void aControllerInJavaIsClosedIfItsRunCannotStart() throws Exception {
        SimulationSetup setup = broken("")
                .withTimeline(List.of(new SimulationSetup.TimedCommand(0, new Command.SwitchSensor("front", false))));
        CommandListener full = result -> {
            throw new IllegalStateException("the disk is full");
        };
        for (ControllerMode mode : ControllerMode.values()) {
            int before = RightTurner.CLOSED.get();
            assertThrows(IllegalStateException.class, () -> new Simulation(setup, mode, full));
            assertEquals(before + 1, RightTurner.CLOSED.get(), mode.name());
        }
    }

    @Test
    void aControllerInJavaThatCannotBeClosedBreaksTheRun() throws Exception {
        SimulationSetup setup = broken("close");
        RunFailedException e =
                assertThrows(RunFailedException.class, () -> HeadlessRun.run(setup, ControllerMode.DIRECT, List.of()));
        assertEquals("the controller cannot be closed: java.io.IOException: still in use", e.getMessage());
    }

    private static SimulationSetup broken(String deed) throws ScenarioException {
        return yard().setup().withController(new ControllerSpec.Provided("right-turner", 0, Map.of("deed", deed)));
    }
}
