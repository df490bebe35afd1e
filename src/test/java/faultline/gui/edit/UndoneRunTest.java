package faultline.gui.edit;

import static faultline.gui.GuiRobot.edt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Session;
import faultline.engine.Simulation;
import faultline.geometry.Pose;
import faultline.gui.GuiRobot;
import faultline.scenario.Journals;
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

/** Edits that are undone and redone while time runs are part of the run, and its journal replays them to the bit. */
@Timeout(value = 1, unit = TimeUnit.MINUTES)
class UndoneRunTest {

    private static final Obstacle BOX = new Obstacle("new-box", new ObstacleShape.Rectangle(0.5, 0.5), new Pose(6, 1.5, 0.3));

    private static void await(BooleanSupplier condition) {
        while (!condition.getAsBoolean()) {
            LockSupport.parkNanos(100_000);
        }
    }

    @Test
    void aRunWithUndoneEditsReplaysToTheBit() throws Exception {
        Scenario office = Scenario.shipped("office.xml");
        try (Session session = Session.start(office.setup())) {
            EditDesk desk = GuiRobot.onEdt(() -> new EditDesk((commands, told) ->
                    session.send(commands, outcomes -> EventQueue.invokeLater(() -> told.accept(outcomes))), () -> { }));
            session.setSpeed(20);
            session.run();
            await(() -> session.frame().world().tick() > 100);
            edt(() -> desk.send(new Command.SwitchSensor("left", false)));
            edt(() -> desk.send(new Command.PutObstacle(BOX)));
            await(() -> GuiRobot.onEdt(desk::undoName).filter("Add new-box"::equals).isPresent());
            edt(desk::undo);
            edt(desk::undo);
            await(() -> session.frame().world().robot().sensor("left").orElseThrow().on() && !session.frame().world().obstacles().contains(BOX));
            edt(desk::redo);
            long then = session.frame().world().tick();
            await(() -> session.frame().world().tick() > then + 200);
            session.pause();
            Journal journal = session.journal().get();
            assertEquals(5, journal.entries().size());
            await(() -> session.frame().world().tick() == journal.ticks());
            assertEquals(session.frame().trajectoryHash(), replayed(Journals.toScenario(office, journal)));
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
