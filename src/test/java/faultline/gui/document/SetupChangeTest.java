package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.session.SessionView;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditedRun;
import faultline.gui.edit.SetupChange;
import faultline.gui.edit.UndoController;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests changes of the setup at tick 60 of a run, which is simulated again. */
@ExtendWith(EdtChecker.class)
class SetupChangeTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.13));
    private static final Command SWITCH = new Command.SwitchSensor("front", false);
    private static final int TICKS = 60;

    @TempDir
    private Path folder;

    private final List<String> deferred = new ArrayList<>();
    private final List<Throwable> failures = new ArrayList<>();
    private EditedRun edited;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;
    private CommandSender sender;
    private UndoController edits;
    private SimulationSetup original;

    @BeforeEach
    void runAWhile() {
        edited = new EditedRun(Path.of("scenarios/office.xml"), new WorkspaceListener() {
            @Override
            public void taskFailed(TaskKind task, Path file, Throwable failure) {
                failures.add(failure);
            }

            @Override
            public void setupChangeDeferred() {
                deferred.add("deferred");
            }
        });
        workspace = edited.workspace();
        run = edited.controller();
        documentStore = edited.documents();
        sender = edited.sender();
        edits = edited.edits();
        original = edited.scenario().setup();
        edited.advanceTo(TICKS);
    }

    @AfterEach
    void close() {
        edited.close();
        assertEquals(List.of(), failures);
    }

    @Test
    void aFaultInThePastIsSimulatedUpToThePresentTick() {
        long before = hash();
        setTimeline(List.of(new TimedCommand(0.2, FAULT)));
        assertEquals(TICKS, edited.tick());
        assertEquals(hashOf(original.withTimeline(List.of(new TimedCommand(0.2, FAULT)))), hash());
        assertNotEquals(before, hash());
        setTimeline(original.timeline());
        assertEquals(before, hash());
    }

    @Test
    void aFutureFaultActsWhenTheRunReachesItsTime() {
        setTimeline(List.of(new TimedCommand(0.63, FAULT)));
        edited.advanceTo(62);
        assertEquals(List.of(), faultsOfLeft());
        edited.advanceTo(63);
        assertEquals(List.of(new Fault.Stuck(0.13)), faultsOfLeft());
    }

    private boolean isRunning() {
        return workspace.session().map(SessionView::status).orElseThrow().running();
    }

    private void awaitMoreTicks() {
        Await.until("the run to resume", this::isRunning);
        long tick = edited.tick();
        SessionFrames.awaitFrame(
                workspace, "more ticks", frame -> frame.snapshot().tick() > tick);
    }

    @Test
    void aRunningRunResumes() {
        runOnEdt(run::toggleRunning);
        Await.until("the run", this::isRunning);
        setTimeline(List.of(new TimedCommand(0.2, FAULT)));
        awaitMoreTicks();
    }

    /** The run is paused when the second change is made, because it is being simulated with the first one. */
    @Test
    void aRunningRunResumesAfterTwoChanges() {
        runOnEdt(run::toggleRunning);
        Await.until("the run", this::isRunning);
        runOnEdt(() -> {
            for (double time : new double[] {0.2, 0.3}) {
                run.change(now -> now.withSetup(now.setup().withTimeline(List.of(new TimedCommand(time, FAULT)))));
                while (isRunning()) {
                    Thread.onSpinWait();
                }
            }
        });
        Await.until("the simulation", () -> workspace.task().isEmpty());
        awaitMoreTicks();
    }

    @Test
    void aManuallyInjectedFaultCanBeMovedAndStaysMoved() throws ScenarioException {
        runOnEdt(() ->
                sender.send(List.of(FAULT, SWITCH, new Command.MoveObstacle("copier", new Pose(3.3, 0.35, 0.5)))));
        Await.until("the edit", () -> edits.undoName().isPresent());
        edited.advanceTo(70);
        List<TimedCommand> timeline = timeline();
        assertEquals(2, timeline.size() - original.timeline().size());
        List<TimedCommand> later = timeline.stream()
                .map(timed -> new TimedCommand(timed.time() + 0.05, timed.command()))
                .toList();
        setTimeline(later);
        assertEquals(later, timeline());
        assertEquals(List.of(new Fault.Stuck(0.13)), faultsOfLeft());
        assertEquals(new Pose(3.3, 0.35, 0.5), callOnEdt(() -> pose("copier")));
        assertSaved(later);
    }

    private void assertSaved(List<TimedCommand> timeline) throws ScenarioException {
        assertTrue(callOnEdt(workspace::isChanged));
        Path file = folder.resolve("saved.xml");
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("the save", () -> !workspace.isChanged());
        assertEquals(timeline, Scenario.load(file).setup().timeline());
    }

    @Test
    void editsAtThePresentTickStayWhenTheTimelineChanges() {
        Pose aside = new Pose(3.3, 0.35, 0.5);
        runOnEdt(() -> sender.send(new Command.MoveObstacle("copier", aside)));
        Await.until("the edit", () -> edits.undoName().isPresent());
        setTimeline(List.of(new TimedCommand(0.7, FAULT)));
        assertEquals(TICKS, edited.tick());
        assertEquals(aside, callOnEdt(() -> pose("copier")), "it shows before the next tick");
        runOnEdt(() -> sender.send(new Command.MoveObstacle("cabinet", new Pose(5, 5.7, 0))));
        Await.until("the second edit", () -> pose("cabinet").y() == 5.7);
        assertEquals(aside, callOnEdt(() -> pose("copier")), "another edit does not drop it");
        runOnEdt(edits::undo);
        runOnEdt(edits::undo);
        Await.until("the original place", () -> pose("copier").y() == 0.3);
    }

    @Test
    void aSwitchAtThePresentTickStaysWhenTheTimelineChanges() {
        runOnEdt(() -> sender.send(SWITCH));
        Await.until("the edit", () -> edits.undoName().isPresent());
        assertFalse(isFrontOn());
        List<TimedCommand> withFault = new ArrayList<>(timeline());
        withFault.add(new TimedCommand(0.9, FAULT));
        setTimeline(withFault);
        assertEquals(TICKS, edited.tick());
        assertFalse(isFrontOn(), "it shows before the next tick");
    }

    private boolean isFrontOn() {
        return SessionFrames.frame(workspace).snapshot().sensors().stream()
                .filter(sensor -> sensor.spec().id().equals("front"))
                .findFirst()
                .orElseThrow()
                .spec()
                .on();
    }

    private Pose pose(String obstacle) {
        return SessionFrames.frame(workspace).snapshot().obstacles().stream()
                .filter(now -> now.id().equals(obstacle))
                .findFirst()
                .orElseThrow()
                .pose();
    }

    @Test
    void undoAndRedoSimulateTheRunAgainAndRepeatedChangesAreOneEdit() {
        long before = hash();
        List<TimedCommand> first = List.of(new TimedCommand(0.2, FAULT));
        List<TimedCommand> second = List.of(new TimedCommand(0.3, FAULT));
        edit(original.timeline(), first);
        edit(first, second);
        long after = hash();
        runOnEdt(edits::undo);
        waitForRun();
        assertEquals(before, hash());
        assertFalse(callOnEdt(workspace::isChanged));
        runOnEdt(edits::redo);
        waitForRun();
        assertEquals(after, hash());
        assertEquals(second, timeline());
    }

    private void edit(List<TimedCommand> from, List<TimedCommand> to) {
        runOnEdt(() -> edits.addSetupEdit(() -> "Move", "one", SetupChange.of(() -> send(from), () -> send(to))));
        setTimeline(to);
    }

    @Test
    void aChangeThatIsCancelledTakesEffectWhenTheRunIsMoved() {
        List<TimedCommand> wanted = List.of(new TimedCommand(0.2, FAULT));
        runOnEdt(() -> {
            send(wanted);
            workspace.cancelTask();
        });
        assertEquals(List.of("deferred"), deferred);
        assertEquals(List.of(), faultsOfLeft());
        runOnEdt(() -> run.navigator().seek(40));
        waitForRun();
        assertEquals(List.of(new Fault.Stuck(0.13)), faultsOfLeft());
    }

    /** A change of the length of a tick restarts the run; another one simulates it again. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.02})
    void aChangeWithWhichTheRunCannotStartTakesEffectLater(double dt) {
        RuntimeException failure = new IllegalStateException("no controller");
        runOnEdt(() -> {
            workspace.setControllerChoice((setup, name) -> {
                throw failure;
            });
            run.change(old -> old.withSetup(new SimulationSetup(
                    original.world(),
                    original.robot(),
                    original.start(),
                    original.controller(),
                    List.of(new TimedCommand(0.2, FAULT)),
                    dt,
                    original.seed(),
                    original.duration())));
        });
        Await.until("the note", () -> !deferred.isEmpty());
        assertEquals(List.of("deferred"), deferred);
        assertEquals(List.of(failure), failures);
        assertEquals(
                dt, callOnEdt(() -> workspace.scenario().orElseThrow().setup().dt()));
        failures.clear();
    }

    @Test
    void anExceptionInAChangeOfTheStartIsNotCaughtAndNoSaveWaitsForIt() {
        List<Throwable> uncaught = new CopyOnWriteArrayList<>();
        Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> uncaught.add(fault));
        RuntimeException failure = new IllegalStateException("no change");
        runOnEdt(() -> {
            run.changeStart(List.of(), true, () -> {
                throw failure;
            });
            assertTrue(workspace.awaitsCommands());
        });
        Await.until("the exception", () -> !uncaught.isEmpty());
        assertEquals(List.of(failure), uncaught);
        assertFalse(callOnEdt(workspace::awaitsCommands));
    }

    @Test
    void aChangeOfTheNameDoesNotSimulateTheRunAgain() {
        runOnEdt(() -> run.change(old -> new Scenario("Mine", "", false, old.setup(), old.expectation())));
        assertTrue(callOnEdt(() -> workspace.task().isEmpty() && workspace.isChanged()));
        assertEquals("Mine", callOnEdt(() -> workspace.scenario().orElseThrow().name()));
    }

    private void send(List<TimedCommand> timeline) {
        run.change(old -> old.withSetup(old.setup().withTimeline(timeline)));
    }

    private void setTimeline(List<TimedCommand> timeline) {
        runOnEdt(() -> send(timeline));
        waitForRun();
    }

    private void waitForRun() {
        Await.until("the run", () -> workspace.task().isEmpty());
    }

    private long hash() {
        return SessionFrames.trajectoryHash(workspace);
    }

    private static long hashOf(SimulationSetup setup) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            for (int i = 0; i < TICKS; i++) {
                simulation.tick();
            }
            return simulation.trajectoryHash();
        }
    }

    private List<TimedCommand> timeline() {
        return callOnEdt(() -> workspace.scenario().orElseThrow().setup().timeline());
    }

    private List<Fault> faultsOfLeft() {
        return callOnEdt(() -> SessionFrames.frame(workspace).snapshot().sensors().stream()
                .filter(sensor -> sensor.spec().id().equals("left"))
                .findFirst()
                .orElseThrow()
                .faults());
    }
}
