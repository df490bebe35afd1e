package faultline.gui.document;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditedRun;
import faultline.gui.edit.UndoController;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that changes of the setup at 0 s act from the start of the run, as in the saved scenario. */
@ExtendWith(EdtChecker.class)
class ChangesAtStartTest {

    private static final int TICKS = 60;
    private static final Pose MOVED = new Pose(0.9, 1.4, 0);
    private static final Command MOVE = new Command.MoveObstacle("cabinet", MOVED);
    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.13));

    private final EditedRun edited = new EditedRun();
    private final Workspace workspace = edited.workspace();
    private final RunController run = edited.controller();
    private final UndoController edits = edited.edits();
    private final CommandSender sender = edited.sender();

    /** The ways in which a run leaves its start. */
    private enum Departure {
        RESUME(RunController::toggleRunning),
        STEP(RunController::step),
        SEEK(run -> run.navigator().seek(TICKS)),
        GO_TO(run -> run.navigator().seekTime(TICKS * 0.01));

        private final Consumer<RunController> action;

        Departure(Consumer<RunController> action) {
            this.action = action;
        }
    }

    @AfterEach
    void close() {
        edited.close();
    }

    @ParameterizedTest
    @EnumSource
    void anObstacleThatWasMovedIsThereFromTheStart(Departure departure) {
        assertRunsAsSaved(departure, MOVE);
    }

    @ParameterizedTest
    @EnumSource
    void theSettingsOfASensorHoldFromTheStart(Departure departure) {
        SensorSpec front = setup().robot().sensor("front").orElseThrow();
        assertRunsAsSaved(departure, new Command.ConfigureSensor(front.withRange(3)));
    }

    @ParameterizedTest
    @EnumSource
    void theControllerHoldsFromTheStart(Departure departure) {
        assertRunsAsSaved(departure, new Command.ConfigureController(new ControllerSpec.None()));
    }

    @ParameterizedTest
    @EnumSource
    void faultsAndChangesOfTheSetupAreBothKept(Departure departure) {
        assertRunsAsSaved(departure, MOVE, FAULT);
    }

    /**
     * Sends commands at 0 s without waiting for their effects, and compares the run with that of the edited scenario.
     */
    private void assertRunsAsSaved(Departure departure, Command... commands) {
        SimulationSetup original = setup();
        runOnEdt(() -> {
            sender.send(List.of(commands));
            departure.action.accept(run);
        });
        awaitTicks(1);
        assertNotEquals(original, setup());
        SessionFrame frame = SessionFrames.frame(workspace);
        long hash = hashOf(setup(), frame.snapshot().tick());
        assertEquals(hash, frame.frame().trajectoryHash());
    }

    @Test
    void aLaterChangeOfARunThatIsMovedToItsStartStaysLater() {
        runOnEdt(() -> run.navigator().seek(TICKS));
        awaitTicks(TICKS);
        runOnEdt(() -> {
            sender.send(MOVE);
            run.step();
        });
        awaitTicks(TICKS + 1);
        long hash = SessionFrames.trajectoryHash(workspace);
        runOnEdt(() -> run.navigator().seek(0));
        SessionFrames.awaitTick(workspace, 0);
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 1);
        runOnEdt(() -> run.navigator().seek(TICKS + 1));
        awaitTicks(TICKS + 1);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
    }

    @ParameterizedTest
    @MethodSource("undoneChanges")
    void undoAfterwardsChangesTheStart(Command change) {
        Scenario original = edited.scenario();
        runOnEdt(() -> {
            sender.send(change);
            run.navigator().seek(TICKS);
        });
        awaitTicks(TICKS);
        runOnEdt(edits::undo);
        Await.until(
                "the undo",
                () -> workspace.task().isEmpty()
                        && workspace.scenario().orElseThrow().equals(original));
        assertEquals(hashOf(original.setup(), TICKS), SessionFrames.trajectoryHash(workspace));
    }

    /** A controller without states hides the expected ones. */
    private static List<Command> undoneChanges() {
        return List.of(MOVE, new Command.ConfigureController(new ControllerSpec.None()));
    }

    @Test
    void aRunThatIsCancelledWhileItBeginsStaysAtTheStart() {
        runOnEdt(() -> {
            sender.send(MOVE);
            run.step();
            workspace.cancelTask();
        });
        runOnEdt(run::step);
        awaitTicks(1);
        SessionFrame frame = SessionFrames.frame(workspace);
        assertEquals(1, frame.snapshot().tick());
        assertEquals(hashOf(setup(), 1), frame.frame().trajectoryHash());
    }

    private SimulationSetup setup() {
        return edited.scenario().setup();
    }

    private void awaitTicks(long ticks) {
        SessionFrames.awaitFrame(workspace, "ticks", frame -> frame.snapshot().tick() >= ticks);
    }

    private static long hashOf(SimulationSetup setup, long ticks) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.ticks() < ticks) {
                simulation.tick();
            }
            return simulation.trajectoryHash();
        }
    }
}
