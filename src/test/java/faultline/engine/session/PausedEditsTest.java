package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.SignalFault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A frame of a paused run shows the effect of commands, but has none of its own: the run replays to the bit. */
@Timeout(value = 1, unit = TimeUnit.MINUTES)
class PausedEditsTest {

    private static final Obstacle DESK =
            new Obstacle("desk", new ObstacleShape.RectangleShape(2, 0.1), new Pose(1, 1.5, 0));

    private Session session;

    /** The left sensor sees the desk at a distance of 0.35 m. */
    @BeforeEach
    void aPausedSessionBesideADesk() {
        session = Session.start(SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of(DESK)), new Pose(1, 1, 0)));
    }

    @AfterEach
    void close() {
        session.close();
    }

    /** Sends commands and waits for the frame that shows their effect. */
    private void send(Command... commands) throws Exception {
        CompletableFuture<Boolean> shown = new CompletableFuture<>();
        session.send(List.of(commands), results -> shown.complete(true));
        shown.get();
    }

    private void inject(Fault fault) throws Exception {
        send(new Command.InjectFault("left", fault));
    }

    private void clear(Fault fault) throws Exception {
        send(new Command.ClearFault("left", fault));
    }

    private void step(int ticks) throws Exception {
        for (int i = 0; i < ticks; i++) {
            session.step();
            session.journal().get();
        }
    }

    private void assertReplaysToTheBit() throws Exception {
        Journal journal = session.journal().get();
        assertEquals(
                ReferenceRun.replay(journal, tick -> true).hashTrace().hashAt(journal.ticks()),
                session.frame().frame().trajectoryHash());
    }

    @ParameterizedTest
    @EnumSource
    void aFaultBeginsInTheNextTick(FaultKind kind) throws Exception {
        step(3);
        inject(kind.createFault(kind.parameter().initial()));
        step(30);
        assertReplaysToTheBit();
    }

    @Test
    void aSensorThatIsStuckAtLastKeepsTheReadingOfTheTickBefore() throws Exception {
        step(3);
        inject(new Fault.Stuck(0.7));
        inject(new SignalFault.StuckAtLast());
        clear(new Fault.Stuck(0.7));
        step(3);
        assertReplaysToTheBit();
    }

    @Test
    void aFaultThatIsTakenAwayAndGivenBackGoesOn() throws Exception {
        Fault drift = new SignalFault.Drift(0.5);
        inject(drift);
        step(3);
        clear(drift);
        inject(drift);
        step(3);
        assertReplaysToTheBit();
    }

    @Test
    void aDelayedSensorReportsLaterWhatItSawBeforeAnEdit() throws Exception {
        inject(new SignalFault.Delayed(0.04));
        step(3);
        send(new Command.MoveObstacle("desk", new Pose(1, 1.3, 0)));
        step(10);
        assertReplaysToTheBit();
    }

    @Test
    void aFaultOfTheOpticsThatIsTakenAwayAtOnceHasNoEffect() throws Exception {
        step(3);
        Fault turned = FaultKind.MISALIGNED.createFault(60);
        inject(turned);
        clear(turned);
        step(3);
        assertReplaysToTheBit();
    }
}
