package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.engine.SimulationSetup;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditedRun;
import faultline.gui.edit.ForkedEdits;
import faultline.gui.edit.UndoController;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Edits while the run is moved to other ticks. Two edits are made, at tick 10 and at tick 20 of 30. */
@ExtendWith(EdtChecker.class)
class RunNavigatorTest {

    private static final Pose FIRST = new Pose(2, 3, 0);
    private static final Pose SECOND = new Pose(2, 3.2, 0);
    private static final long FAR = 1_000_000_000;

    @TempDir
    private Path folder;

    private final List<ForkedEdits> forks = new ArrayList<>();
    private final List<Long> undone = new ArrayList<>();
    private EditedRun edited;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;
    private CommandSender sender;
    private UndoController edits;
    private Pose original;

    @BeforeEach
    void editTwice() {
        edited = new EditedRun(Path.of("scenarios/collision-on-purpose.xml"), new TaskFailures());
        workspace = edited.workspace();
        run = edited.controller();
        documentStore = edited.documents();
        sender = edited.sender();
        edits = edited.edits();
        runOnEdt(() -> {
            edits.setForkListener(forks::add);
            edits.setUndoListener(undone::add);
        });
        original = pole();
        edited.advanceTo(10);
        edit(new Command.MoveObstacle("pole", FIRST));
        edited.advanceTo(20);
        edit(new Command.MoveObstacle("pole", SECOND));
        edited.advanceTo(30);
    }

    @AfterEach
    void close() {
        edited.close();
    }

    @Test
    void seekingBeforeAnEditMakesItRedoableAndSeekingPastItUndoable() {
        seek(15);
        assertEquals(FIRST, pole());
        assertTrue(
                callOnEdt(() -> edits.undoName().isPresent() && edits.redoName().isPresent()));
        seek(5);
        assertEquals(original, pole());
        assertEquals(Optional.empty(), callOnEdt(edits::undoName));
        edited.advanceTo(30);
        assertEquals(SECOND, pole());
        assertEquals(Optional.empty(), callOnEdt(edits::redoName));
        assertEquals(List.of(), forks, "nothing else happened than before");
    }

    @Test
    void aTimeIsThatOfTheFirstTickNotBeforeIt() {
        assertEquals(0.30, callOnEdt(run.navigator()::currentTime), 1e-12);
        runOnEdt(() -> run.navigator().seekTime(0.121));
        Await.until("tick 13", () -> workspace.task().isEmpty() && SessionFrames.tick(workspace) == 13);
        assertEquals(FIRST, pole());
    }

    @Test
    void theTickAtWhichAnEditWasMadeShowsIt() {
        seek(10);
        assertEquals(FIRST, pole());
        edit(new Command.SwitchSensor("left", false));
        assertEquals(FIRST, pole(), "a new edit comes after it");
        assertEquals(List.of(new ForkedEdits(1, 0)), forks, "only the edit at tick 20 is ahead");
    }

    /** As if the user had cancelled the restart that a change of the length of the ticks from 0.01 s makes. */
    private void changeTickWithoutRestart(double tick) {
        runOnEdt(() -> {
            run.change(scenario -> scenario.withSetup(scenario.setup().withTick(tick)));
            workspace.cancelTask();
        });
        Await.until(
                "the change", () -> workspace.scenario().orElseThrow().setup().dt() == tick);
    }

    private void awaitTime(double seconds) {
        Await.until(
                seconds + " s",
                () -> workspace.task().isEmpty()
                        && SessionFrames.frame(workspace).dt() != 0.01);
        assertEquals(seconds, callOnEdt(run.navigator()::currentTime), 1e-12);
    }

    @Test
    void aMoveAfterACancelledRestartIsToTheTimeOfTheTickOfTheRun() {
        changeTickWithoutRestart(0.02);
        runOnEdt(() -> run.navigator().seek(20));
        awaitTime(0.2);
        seek(5);
        assertEquals(0.1, callOnEdt(run.navigator()::currentTime), 1e-12, "the run has the changed ticks");
    }

    @ParameterizedTest
    @CsvSource({"0.02, 15", "0.005, 60"})
    void theFurthestTickAfterACancelledRestartIsAtTheSameTime(double tick, long furthest) {
        seek(10);
        changeTickWithoutRestart(tick);
        assertEquals(30, callOnEdt(run.navigator()::furthestTick), "the run has its ticks");
        runOnEdt(() -> run.navigator().seek(5));
        awaitTime(tick == 0.02 ? 0.06 : 0.05);
        assertEquals(furthest, callOnEdt(run.navigator()::furthestTick));
        seek(2);
        assertEquals(furthest, callOnEdt(run.navigator()::furthestTick));
    }

    @Test
    void aTimeAfterACancelledRestartIsShownAtTheTickOfTheRun() {
        List<Long> shown = new ArrayList<>();
        runOnEdt(() -> workspace.addListener(new WorkspaceListener() {
            @Override
            public void seekStarted(long tick) {
                shown.add(tick);
            }
        }));
        changeTickWithoutRestart(0.02);
        runOnEdt(() -> run.navigator().seekTime(0.12));
        awaitTime(0.12);
        assertEquals(List.of(12L), shown);
    }

    @ParameterizedTest
    @CsvSource({"0.02, 0.28", "0.005, 0.295"})
    void aStepBackAfterACancelledRestartIsOneOfTheChangedTicks(double tick, double time) {
        changeTickWithoutRestart(tick);
        runOnEdt(run.navigator()::stepBack);
        awaitTime(time);
    }

    @Test
    void aChangeAfterACancelledRestartIsSimulatedUpToTheTimeOfTheRun() {
        changeTickWithoutRestart(0.02);
        runOnEdt(this::changeSeed);
        awaitTime(0.3);
    }

    @Test
    void aStepBackFromTheFirstTickEndsAtTheStart() {
        seek(1);
        runOnEdt(run.navigator()::stepBack);
        Await.until("the start", () -> workspace.task().isEmpty() && SessionFrames.tick(workspace) == 0);
    }

    @Test
    void allOfARecordedRunCanBeReachedUntilACommandChangesIt() throws Exception {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        Scenario recorded = new Scenario(
                office.name(), office.description(), true, office.setup().withDuration(2), office.expectation());
        Path file = folder.resolve("recorded.xml");
        recorded.save(file);
        OpenDocument before = callOnEdt(() -> workspace.openDocument().orElseThrow());
        assertEquals(OptionalLong.empty(), callOnEdt(run.navigator()::replayEnd));
        runOnEdt(() -> documentStore.open(file));
        Await.until("the record", () -> workspace.openDocument().orElseThrow() != before);
        assertEquals(OptionalLong.of(200), callOnEdt(run.navigator()::replayEnd));
        assertEquals(200, callOnEdt(run.navigator()::furthestTick));
        edit(new Command.SwitchSensor("left", false));
        assertEquals(OptionalLong.empty(), callOnEdt(run.navigator()::replayEnd));
        assertEquals(0, callOnEdt(run.navigator()::furthestTick));
    }

    @Test
    void aChangeOfTheSetupForgetsTheTicksOfTheRunBefore() {
        seek(5);
        assertEquals(30, callOnEdt(run.navigator()::furthestTick));
        runOnEdt(
                () -> run.change(scenario -> scenario.withSetup(scenario.setup().withSeed(7))));
        Await.until("the run with the seed", () -> workspace.task().isEmpty());
        assertEquals(5, callOnEdt(run.navigator()::furthestTick));
        seek(3);
        assertEquals(5, callOnEdt(run.navigator()::furthestTick));
    }

    /** After a restart, nothing remains in the run of what the edit has caused. */
    @Test
    void anUndoReportsTheTickOfTheEditUntilARestart() {
        runOnEdt(edits::undo);
        waitForPole(FIRST);
        Await.until("the report", () -> undone.size() == 1);
        runOnEdt(run::restart);
        SessionFrames.awaitTick(workspace, 0);
        runOnEdt(edits::undo);
        waitForPole(original);
        assertEquals(List.of(21L), undone);
    }

    @Test
    void seekingDoesNotChangeTheEditedScenario() throws ScenarioException {
        seek(5);
        waitForEdited(SECOND);
        Path file = folder.resolve("saved.xml");
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("the save", () -> !workspace.isChanged());
        assertEquals(SECOND, pole(Scenario.load(file).setup().world().obstacles()));
        runOnEdt(run::restart);
        SessionFrames.awaitTick(workspace, 0);
        assertEquals(SECOND, pole());
    }

    @Test
    void allEditsCanBeUndoneAfterARestartFromAnEarlierTick() {
        seek(5);
        runOnEdt(run::restart);
        SessionFrames.awaitTick(workspace, 0);
        runOnEdt(edits::undo);
        waitForPole(FIRST);
        runOnEdt(edits::undo);
        waitForPole(original);
    }

    @Test
    void anEditInThePastKeepsLaterEditsRedoableAndReportsTheFork() {
        seek(5);
        edit(new Command.SetPlatform(0.2, 0.2, 0.4));
        assertEquals(List.of(new ForkedEdits(2, 0)), forks);
        edited.advanceTo(30);
        assertEquals(original, pole(), "the edit is no longer executed");
        runOnEdt(edits::redo);
        waitForPole(FIRST);
        runOnEdt(edits::redo);
        waitForPole(SECOND);
        runOnEdt(edits::undo);
        runOnEdt(edits::undo);
        waitForPole(original);
        runOnEdt(edits::undo);
        SessionFrames.awaitFrame(
                workspace,
                "the platform as it was",
                frame -> frame.snapshot().robot().length() != 0.2);
        assertEquals(Optional.empty(), callOnEdt(edits::undoName));
    }

    @Test
    void anEditInThePastThatIsRefusedKeepsTheLaterOnes() {
        seek(5);
        runOnEdt(() -> sender.send(new Command.MoveObstacle("no-such-obstacle", FIRST)));
        edited.advanceTo(30);
        assertEquals(SECOND, pole());
        assertEquals(List.of(), forks);
    }

    @Test
    void editsInThePastPrecedeTheLaterOnes() {
        seek(15);
        edit(new Command.SetPlatform(0.2, 0.2, 0.4));
        edit(new Command.SwitchSensor("left", false));
        runOnEdt(edits::redo);
        waitForPole(SECOND);
        for (int i = 0; i < 4; i++) {
            runOnEdt(edits::undo);
        }
        waitForPole(original);
        assertTrue(callOnEdt(() -> SessionFrames.frame(workspace)
                .snapshot()
                .robot()
                .sensor("left")
                .orElseThrow()
                .on()));
        assertEquals(Optional.empty(), callOnEdt(edits::undoName));
    }

    @Test
    void anEditIsDoneAtATickBetweenItAndItsUndo() {
        runOnEdt(edits::undo);
        waitForPole(FIRST);
        edited.advanceTo(40);
        seek(25);
        assertEquals(SECOND, pole());
        runOnEdt(edits::undo);
        waitForPole(FIRST);
    }

    @Test
    void commandsSentDuringASeekAreExecutedAfterIt() {
        runOnEdt(() -> {
            run.navigator().seek(15);
            sender.send(new Command.SwitchSensor("left", false));
            run.step();
        });
        SessionFrames.awaitTick(workspace, 16);
        assertFalse(callOnEdt(() -> SessionFrames.frame(workspace)
                .snapshot()
                .robot()
                .sensor("left")
                .orElseThrow()
                .on()));
        assertEquals(FIRST, pole());
    }

    @Test
    void aLongSeekReportsProgressAndCancellingItLeavesTheRunUnchanged() {
        runOnEdt(() -> run.navigator().seek(FAR));
        Await.until(
                "some of the way",
                () -> workspace.task().orElseThrow().progress().fraction().orElse(0) > 1e-6);
        runOnEdt(workspace::cancelTask);
        assertEquals(Optional.empty(), callOnEdt(workspace::task));
        assertEquals(30, edited.tick());
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 31);
        assertEquals(SECOND, pole());
    }

    @Test
    void aReplayStartsOnlyWhenTheCancelledOneBeforeHasEnded() {
        HeldControllers controllers = new HeldControllers();
        Scenario shipped = callOnEdt(() -> workspace.scenario().orElseThrow());
        SimulationSetup setup = shipped.setup();
        Scenario held =
                shipped.withSetup(setup.withController(new ControllerSpec.Chosen(setup.controller(), controllers)));
        AtomicBoolean opened = new AtomicBoolean();
        runOnEdt(() -> documentStore.openGenerated(held, () -> opened.set(true)));
        Await.until("the scenario with the controllers", opened::get);
        edited.advanceTo(3);
        controllers.hold();
        runOnEdt(() -> run.navigator().seek(2));
        Await.until("a replay in its first tick", () -> controllers.waiting.get() == 1);
        for (int i = 0; i < 10; i++) {
            runOnEdt(() -> run.navigator().seek(2));
        }
        controllers.release();
        Await.until("tick 2", () -> workspace.task().isEmpty() && edited.tick() == 2);
        assertEquals(3, controllers.started.get());
    }

    /** Makes controllers that stand still, and that do not answer while they are held, even if they are interrupted. */
    private static final class HeldControllers implements ControllerSource {
        private final AtomicInteger started = new AtomicInteger();
        private final AtomicInteger waiting = new AtomicInteger();
        private volatile CompletableFuture<Void> release = CompletableFuture.completedFuture(null);

        void hold() {
            release = new CompletableFuture<>();
        }

        void release() {
            release.complete(null);
        }

        @Override
        public Controller start(RunConditions run) {
            started.incrementAndGet();
            return observation -> {
                waiting.incrementAndGet();
                release.join();
                waiting.decrementAndGet();
                return new Decision(0, 0, Telemetry.ofState(ControllerState.of("HELD")));
            };
        }

        @Override
        public boolean limitsAnswerTime() {
            return true;
        }
    }

    @Test
    void anOpenThatIsCancelledChangesNothing() {
        Optional<Path> before = callOnEdt(workspace::file);
        runOnEdt(() -> {
            documentStore.open(Path.of("scenarios/office.xml"));
            workspace.cancelTask();
        });
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 31);
        assertEquals(before, callOnEdt(workspace::file));
        assertEquals(SECOND, pole());
    }

    private List<Integer> countDeferredChanges() {
        List<Integer> reports = new ArrayList<>();
        runOnEdt(() -> workspace.addListener(new WorkspaceListener() {
            @Override
            public void setupChangeDeferred() {
                reports.add(reports.size() + 1);
            }
        }));
        return reports;
    }

    private void changeSeed() {
        run.change(scenario -> scenario.withSetup(scenario.setup().withSeed(7)));
    }

    @Test
    void aMoveThatIsCancelledLeavesARunWithoutTheChangeBefore() {
        List<Integer> reports = countDeferredChanges();
        runOnEdt(() -> {
            changeSeed();
            run.navigator().seek(5);
            workspace.cancelTask();
        });
        assertEquals(List.of(1), reports);
        seek(5);
        runOnEdt(() -> {
            run.navigator().seek(8);
            workspace.cancelTask();
        });
        assertEquals(List.of(1), reports, "the run has the change");
    }

    /** After a restart, an undo changes the start of the run, as soon as the run has answered. */
    @Test
    void aMoveThatIsCancelledLeavesARunWithoutTheUndoBefore() {
        runOnEdt(run::restart);
        Await.until("the restart", () -> workspace.task().isEmpty() && SessionFrames.tick(workspace) == 0);
        edited.advanceTo(10);
        List<Integer> reports = countDeferredChanges();
        runOnEdt(() -> {
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void titleChanged() {
                    if (editedPole().equals(FIRST)) {
                        // The move was requested after the undo, so it cannot be complete yet.
                        EventQueue.invokeLater(workspace::cancelTask);
                    }
                }
            });
            edits.undo();
            run.navigator().seek(5);
        });
        waitForEdited(FIRST);
        Await.until("the report", () -> reports.equals(List.of(1)));
        assertEquals(SECOND, pole());
    }

    @Test
    void aMoveARestartOrAChangeDoesNotEndTheOpeningOfAScenario() throws Exception {
        Path office = Path.of("scenarios/office.xml");
        List<Integer> reports = countDeferredChanges();
        CompletableFuture<Scenario> found = new CompletableFuture<>();
        runOnEdt(() -> {
            documentStore.open(office, found::get);
            run.navigator().seek(5);
            run.restartUnlessOpening();
            changeSeed();
        });
        found.complete(Scenario.load(office));
        Await.until("the scenario", () -> workspace.file().equals(Optional.of(office)));
        assertEquals(List.of(), reports);
    }

    @Test
    void aChangeBeforeTheOpeningOfAScenarioIsCancelledIsReported() {
        List<Integer> reports = countDeferredChanges();
        runOnEdt(() -> {
            documentStore.open(Path.of("scenarios/office.xml"), () -> new CompletableFuture<Scenario>().get());
            changeSeed();
            assertEquals(
                    TaskKind.OPEN, workspace.task().map(WorkspaceTask::kind).orElseThrow());
            workspace.cancelTask();
        });
        assertEquals(List.of(1), reports);
    }

    private void edit(Command command) {
        SessionFrame before = SessionFrames.frame(workspace);
        runOnEdt(() -> {
            sender.beginGesture();
            sender.send(command);
            sender.endGesture();
        });
        SessionFrames.awaitFrame(workspace, command + " to be executed", frame -> frame != before);
        assertTrue(callOnEdt(() -> edits.undoName().isPresent()));
    }

    private void seek(long tick) {
        runOnEdt(() -> run.navigator().seek(tick));
        Await.until("tick " + tick, () -> workspace.task().isEmpty() && SessionFrames.tick(workspace) == tick);
    }

    /** Waits until the results of commands have edited the scenario. */
    private void waitForEdited(Pose pose) {
        Await.until("the scenario's pole at " + pose, () -> {
            SessionFrames.poll(workspace);
            return editedPole().equals(pose);
        });
    }

    private Pose editedPole() {
        return pole(workspace.scenario().orElseThrow().setup().world().obstacles());
    }

    private Pose pole() {
        return callOnEdt(() -> pole(SessionFrames.frame(workspace).snapshot().obstacles()));
    }

    private static Pose pole(List<Obstacle> obstacles) {
        return obstacles.stream()
                .filter(obstacle -> obstacle.id().equals("pole"))
                .findFirst()
                .orElseThrow()
                .pose();
    }

    private void waitForPole(Pose pose) {
        SessionFrames.awaitFrame(
                workspace, "the pole at " + pose, frame -> pole(frame.snapshot().obstacles())
                        .equals(pose));
    }
}
