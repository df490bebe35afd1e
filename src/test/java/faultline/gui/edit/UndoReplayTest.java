package faultline.gui.edit;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.gui.GuiRobot;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.EventQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Edits that are undone and redone during a run are part of it, and its journal replays them exactly. */
@Timeout(value = 1, unit = TimeUnit.MINUTES)
class UndoReplayTest {

    private static final Obstacle BOX =
            new Obstacle("new-box", new ObstacleShape.RectangleShape(0.5, 0.5), new Pose(6, 1.5, 0.3));

    private static void await(BooleanSupplier condition) {
        while (!condition.getAsBoolean()) {
            LockSupport.parkNanos(100_000);
        }
    }

    @Test
    void aRunWithUndoneEditsReplaysToTheBit() throws Exception {
        Scenario office = Scenario.loadShipped("office.xml");
        try (Session session = Session.start(office.setup())) {
            CommandSender sender = new CommandSender((commands, onExecuted) ->
                    session.send(commands, results -> EventQueue.invokeLater(() -> onExecuted.accept(results))));
            UndoController controller = GuiRobot.callOnEdt(() -> new UndoController(sender, () -> {}));
            session.setSpeed(20);
            session.resume();
            await(() -> session.frame().snapshot().tick() > 100);
            runOnEdt(() -> sender.send(new Command.SwitchSensor("left", false)));
            runOnEdt(() -> sender.send(new Command.PlaceObstacle(BOX)));
            await(() -> GuiRobot.callOnEdt(controller::undoName)
                    .filter("Add new-box"::equals)
                    .isPresent());
            runOnEdt(controller::undo);
            runOnEdt(controller::undo);
            await(() -> session.frame()
                            .snapshot()
                            .robot()
                            .sensor("left")
                            .orElseThrow()
                            .on()
                    && !session.frame().snapshot().obstacles().contains(BOX));
            runOnEdt(controller::redo);
            long then = session.frame().snapshot().tick();
            await(() -> session.frame().snapshot().tick() > then + 200);
            session.pause();
            Journal journal = session.journal().get();
            assertEquals(5, journal.entries().size());
            await(() -> session.frame().snapshot().tick() == journal.ticks());
            assertEquals(session.frame().frame().trajectoryHash(), replayed(JournalScenario.create(office, journal)));
        }
    }

    private static long replayed(Scenario scenario) {
        try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
            while (simulation.ticks() < scenario.setup().ticks()) {
                simulation.tick();
            }
            return simulation.trajectoryHash();
        }
    }
}
