package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.metrics.RunResult;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.external.ControllerChoice;
import faultline.geometry.Vector2;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Comparison of the run with a reference run, without a display. */
@ExtendWith(EdtChecker.class)
class ComparisonControllerTest {

    private static final Path OFFICE = Path.of("scenarios/office.xml");
    private static final int TICKS = 60;
    private static final int CHANGED = 20;
    private static final double MANY_HOURS = 80_000;

    private final List<String> failures = new ArrayList<>();
    private Workspace workspace;
    private RunController run;
    private ComparisonController controller;

    @BeforeEach
    void runAndCaptureReference() {
        runOnEdt(() -> {
            workspace = new Workspace();
            workspace.addListener(new FailureRecorder());
            run = new RunController(workspace);
            controller = new ComparisonController(workspace, run.navigator());
        });
        open(OFFICE);
        step(TICKS);
        runOnEdt(controller::captureCurrentRun);
        waitFor("the reference run", comparison -> comparison.isPresent());
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    private void open(Path file) {
        runOnEdt(() -> new DocumentStore(workspace).open(file));
        SessionFrames.awaitScenario(workspace);
    }

    private Optional<RunComparison> update() {
        return SessionFrames.poll(workspace).flatMap(controller::update);
    }

    private void waitFor(String what, Predicate<Optional<RunComparison>> condition) {
        Await.until(what, () -> condition.test(update()));
    }

    private void waitForTick(long tick) {
        Await.until("tick " + tick, () -> {
            update();
            return tick() == tick;
        });
    }

    private long tick() {
        return SessionFrames.poll(workspace)
                .map(frame -> frame.snapshot().tick())
                .orElse(-1L);
    }

    private void step(int ticks) {
        long from = callOnEdt(this::tick);
        for (int i = 0; i < ticks; i++) {
            runOnEdt(run::step);
        }
        waitForTick(from + ticks);
    }

    /** Such as that it was interrupted. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the program is a shell script")
    void theLastWordsOfACancelledGhostAreNotShown(boolean replaced, @TempDir Path folder) throws IOException {
        Path program = Files.writeString(
                folder.resolve("waiter.sh"),
                "read hello; echo '{\"type\":\"ready\",\"protocol\":1,\"name\":\"waiter\"}'; echo begun >&2; "
                        + "cat > /dev/null; echo interrupted >&2");
        List<String> lines = new CopyOnWriteArrayList<>();
        runOnEdt(() -> controller.compareWith(ControllerChoice.of("sh " + program), lines::add, setup -> {}));
        Await.until("the first line", () -> !lines.isEmpty());
        runOnEdt(replaced ? controller::captureCurrentRun : controller::removeReference);
        Await.until("the end of the lines", () -> Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("faultline-child-errors")));
        assertEquals(List.of("begun"), lines);
    }

    private void restart() {
        runOnEdt(run::restart);
        waitForTick(0);
    }

    private OptionalLong divergence() {
        return callOnEdt(() -> update().orElseThrow().divergence().stream()
                .mapToLong(RunEvent.Diverged::tick)
                .findFirst());
    }

    @Test
    void aRunThatPassesTheEndOfTheReferenceRunHasComparedAllOfIt() {
        assertFalse(callOnEdt(() -> update().orElseThrow().whole()));
        step(1);
        assertTrue(callOnEdt(() -> update().orElseThrow().whole()));
        restart();
        assertFalse(callOnEdt(() -> update().orElseThrow().whole()));
    }

    @Test
    void onlyARunWithTicksCanBeKept() {
        assertTrue(callOnEdt(controller::canCapture));
        runOnEdt(() -> run.navigator().seek(0));
        waitForTick(0);
        assertTrue(callOnEdt(controller::canCapture), "a run that was moved back still has its ticks");
        restart();
        Await.until("a restarted run has no ticks", () -> !controller.canCapture());
    }

    /** Switches the left sensor off at the start of tick CHANGED and runs to the end. */
    private void runDifferently() {
        runDifferently(new Command.SwitchSensor("left", false));
    }

    /** Executes a command at the start of tick CHANGED and runs to the end. */
    private void runDifferently(Command command) {
        restart();
        step(CHANGED - 1);
        runOnEdt(() -> run.send(List.of(command), results -> {}));
        step(TICKS - CHANGED + 1);
    }

    @Test
    void theSameRunAgainDoesNotDiverge() {
        restart();
        step(TICKS);
        assertEquals(OptionalLong.empty(), divergence());
        assertFalse(callOnEdt(() -> update().orElseThrow().seedDiffers()));
    }

    @Test
    void anotherRunDivergesInTheTickInWhichTheFirstBitDiffers() {
        runDifferently();
        assertEquals(OptionalLong.of(CHANGED), divergence());
        ReferenceRun reference = callOnEdt(() -> update().orElseThrow().run());
        SessionFrame frame = SessionFrames.frame(workspace);
        assertTrue(LongStream.range(0, CHANGED)
                .allMatch(tick -> reference.hashTrace().hashAt(tick)
                        == frame.recording().hashTrace().hashAt(tick)));
        assertTrue(LongStream.rangeClosed(CHANGED, TICKS)
                .allMatch(tick -> reference.hashTrace().hashAt(tick)
                        != frame.recording().hashTrace().hashAt(tick)));
    }

    private ReferenceRun ghostWith(ControllerChoice selection, String name) {
        runOnEdt(() -> controller.compareWith(selection, line -> {}, setup -> {}));
        waitFor("the ghost", comparison -> comparison
                .filter(made -> name.equals(made.name()))
                .isPresent());
        return callOnEdt(() -> update().orElseThrow().run());
    }

    private static long finalHash(SimulationSetup setup) {
        return HeadlessRun.run(setup, ControllerMode.DIRECT, List.of()).trajectoryHash();
    }

    @Test
    void anotherControllerDrivesTheGhostThroughTheEditedScenario() {
        runOnEdt(() -> run.send(List.of(new Command.SwitchSensor("left", false)), results -> {}));
        ReferenceRun still = ghostWith(ControllerChoice.of("none"), "none");
        SimulationSetup edited =
                callOnEdt(() -> workspace.scenario().orElseThrow().setup());
        assertEquals(edited.ticks(), still.lastTick());
        assertEquals(
                finalHash(edited.withController(new ControllerSpec.None())),
                still.hashTrace().hashAt(still.lastTick()));
        ReferenceRun follower = ghostWith(ControllerChoice.of("wall-follower"), "wall-follower");
        assertEquals(finalHash(edited), follower.hashTrace().hashAt(follower.lastTick()));
        RunResult result = HeadlessRun.run(edited, ControllerMode.DIRECT, List.of());
        assertEquals(result.coverage().orElseThrow(), follower.measures().coverage());
        assertEquals(result.distanceRms().orElseThrow(), follower.measures().distanceRms());
        assertEquals(RunMeasures.NONE, still.measures());
        assertNotEquals(finalHash(edited), still.hashTrace().hashAt(still.lastTick()));
    }

    @Test
    void aGhostWithoutTicksIsShownAndItsControllerHasStarted(@TempDir Path folder) throws Exception {
        Scenario office = Scenario.load(OFFICE);
        Path file = folder.resolve("no-tick.xml");
        office.withSetup(office.setup().withDuration(1e-9)).save(file);
        open(file);
        Await.until("the other scenario", () -> workspace.file().equals(Optional.of(file)));
        AtomicInteger starts = new AtomicInteger();
        runOnEdt(() ->
                controller.compareWith(ControllerChoice.of("none"), line -> {}, setup -> starts.incrementAndGet()));
        waitFor("the ghost", Optional::isPresent);
        assertEquals(0, callOnEdt(() -> update().orElseThrow().run().lastTick()));
        assertEquals(1, starts.get());
    }

    @Test
    void aDivergenceIsStillKnownAfterSeekingBeforeIt() {
        runDifferently();
        runOnEdt(() -> run.navigator().seek(CHANGED / 2));
        waitForTick(CHANGED / 2);
        assertEquals(OptionalLong.of(CHANGED), divergence());
    }

    @Test
    void aDivergenceIsForgottenWhenTheRunIsEditedBeforeIt() {
        runDifferently(new Command.SetPlatform(0.25, 0.2, 0.1));
        assertTrue(divergence().isPresent());
        runOnEdt(() -> run.navigator().seek(CHANGED / 2));
        waitForTick(CHANGED / 2);
        runOnEdt(() -> run.send(List.of(new Command.SwitchSensor("rear", true)), results -> {}));
        step(TICKS);
        assertEquals(OptionalLong.empty(), divergence(), "the rear sensor was on already");
    }

    @Test
    void aDivergenceByAFaultIsKeptWhenTheRunIsEditedBeforeIt() {
        runDifferently();
        runOnEdt(() -> run.navigator().seek(CHANGED / 2));
        waitForTick(CHANGED / 2);
        runOnEdt(() -> run.send(List.of(new Command.SwitchSensor("rear", true)), results -> {}));
        step(TICKS);
        assertEquals(OptionalLong.of(CHANGED), divergence());
    }

    private void change(UnaryOperator<SimulationSetup> change) {
        runOnEdt(() -> run.change(scenario -> scenario.withSetup(change.apply(scenario.setup()))));
        Await.until("the run with the change", () -> workspace.task().isEmpty());
    }

    @Test
    void anEarlierDivergenceOfARunThatIsSimulatedAgainReplacesOneAhead() {
        runDifferently();
        runOnEdt(() -> run.navigator().seek(CHANGED / 2));
        waitForTick(CHANGED / 2);
        change(setup -> setup.withStart(
                setup.start().withPosition(setup.start().position().plus(new Vector2(1e-3, 0)))));
        assertEquals(OptionalLong.of(0), divergence());
    }

    /** The command that made the run differ is still ahead, but the run differs before. */
    @Test
    void aDivergenceAheadIsForgottenWhenTheRunIsSimulatedAgain() {
        runDifferently(new Command.SetPlatform(0.25, 0.2, 0.1));
        runOnEdt(() -> run.navigator().seek(CHANGED / 2));
        waitForTick(CHANGED / 2);
        int planned = CHANGED - 5;
        change(setup -> setup.withTimeline(List.of(
                new SimulationSetup.TimedCommand(setup.timeOf(planned), new Command.SwitchSensor("left", false)))));
        assertEquals(OptionalLong.empty(), divergence());
        step(CHANGED / 2);
        assertEquals(OptionalLong.of(planned), divergence());
    }

    @Test
    void aRestartClearsTheDivergenceAndKeepsTheReferenceRun() {
        runDifferently();
        restart();
        assertEquals(OptionalLong.empty(), divergence());
    }

    @Test
    void anotherScenarioRemovesTheReferenceRun() {
        open(Path.of("scenarios/yard.xml"));
        waitFor("no reference run", comparison -> comparison.isEmpty());
    }

    @Test
    void theRunOfAFileCanBeTheReferenceAndADifferentSeedIsReported(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("seed-7.xml");
        Scenario office = Scenario.load(OFFICE);
        office.withSetup(office.setup().withSeed(7).withDuration(0.3)).save(file);
        runOnEdt(() -> controller.loadReference(file));
        waitFor(
                "the other reference run",
                comparison -> comparison.filter(RunComparison::seedDiffers).isPresent());
        assertEquals(30, callOnEdt(() -> update().orElseThrow().run().lastTick()));
    }

    @Test
    void aSeedThatIsChangedAfterwardsIsReported() {
        runOnEdt(
                () -> run.change(scenario -> scenario.withSetup(scenario.setup().withSeed(7))));
        waitFor(
                "the report",
                comparison -> comparison.filter(RunComparison::seedDiffers).isPresent());
        runOnEdt(
                () -> run.change(scenario -> scenario.withSetup(scenario.setup().withSeed(1))));
        waitFor("no report", comparison -> !comparison.orElseThrow().seedDiffers());
    }

    @Test
    void anInvalidFileIsReportedAndTheOldReferenceRunStays(@TempDir Path folder) {
        runOnEdt(() -> controller.loadReference(folder.resolve("none.xml")));
        Await.until("the failure", () -> failures.contains("GHOST none.xml"));
        assertTrue(callOnEdt(() -> update().isPresent()));
    }

    @Test
    void itCanBeRemoved() {
        runOnEdt(controller::removeReference);
        assertTrue(callOnEdt(() -> update().isEmpty()));
    }

    @Test
    void aReferenceRunRemovedWhileRunningStopsAndNeverAppears(@TempDir Path folder) throws Exception {
        runOnEdt(controller::removeReference);
        Path file = folder.resolve("long.xml");
        Scenario office = Scenario.load(OFFICE);
        office.withSetup(office.setup().withDuration(MANY_HOURS)).save(file);
        runOnEdt(() -> controller.loadReference(file));
        Await.until("the reference run to be replayed", () -> isReferenceRunning());
        assertTrue(callOnEdt(() -> controller.pending().isPresent()));
        runOnEdt(controller::removeReference);
        assertFalse(callOnEdt(() -> controller.pending().isPresent()));
        Await.until("the end of the reference run", () -> !isReferenceRunning());
        assertTrue(callOnEdt(() -> update().isEmpty()));
        assertEquals(List.of(), failures, "a cancellation is not a failure");
    }

    @Test
    void theOldReferenceRunIsHiddenWhileAnotherOneIsMadeAndReturnsIfThatIsCancelled(@TempDir Path folder)
            throws Exception {
        String name = callOnEdt(() -> update().orElseThrow().name());
        Path file = folder.resolve("long.xml");
        Scenario office = Scenario.load(OFFICE);
        office.withSetup(office.setup().withDuration(MANY_HOURS)).save(file);
        runOnEdt(() -> controller.loadReference(file));
        assertTrue(callOnEdt(() -> update().isEmpty()), "it could be mistaken for the other one");
        assertEquals(
                "long.xml", callOnEdt(() -> controller.pending().orElseThrow().name()));
        Await.until(
                "some progress",
                () -> controller.pending().orElseThrow().progress().fraction().orElse(0) > 0);
        runOnEdt(controller::cancelPending);
        assertEquals(name, callOnEdt(() -> update().orElseThrow().name()));
        Await.until("the end of the other one", () -> !isReferenceRunning());
        assertEquals(List.of(), failures, "a cancellation is not a failure");
    }

    private static boolean isReferenceRunning() {
        return Thread.getAllStackTraces().values().stream().flatMap(Stream::of).anyMatch(call -> call.getClassName()
                .equals(ReferenceRun.class.getName()));
    }

    private final class FailureRecorder implements WorkspaceListener {
        @Override
        public void taskFailed(TaskKind what, Path file, Throwable why) {
            failures.add(what + " " + file.getFileName());
        }
    }
}
