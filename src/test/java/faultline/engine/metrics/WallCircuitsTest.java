package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.walls.WallCircuit;
import faultline.geometry.Pose;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Circuits around a pole. */
class WallCircuitsTest {

    private static final SimulationSetup POLE = SimulationSetup.of(
            new WorldSpec(
                    4,
                    4,
                    false,
                    3,
                    List.of(new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(2, 2, 0)))),
            new Pose(1, 1, 0));

    private final WallCircuits circuits = new WallCircuits();

    private WallCircuit at(double distance) {
        return circuits.forCarryOn(POLE.withController(ControllerSpec.WallFollowing.DEFAULT.withDistance(distance)));
    }

    @Test
    void theLatestSixteenAreKept() {
        WallCircuit first = at(0.5);
        WallCircuit second = at(1);
        assertSame(first, at(0.5));
        for (int i = 0; i < 15; i++) {
            at(2 + i);
        }
        assertSame(first, at(0.5));
        assertNotSame(second, at(1));
    }

    /** A circuit at 3.2 km has a million places, and two million are kept. */
    @Test
    void circuitsThatAreLargeTogetherAreNotKept() {
        WallCircuit small = at(0.5);
        WallCircuit large = at(3200);
        assertSame(large, at(3200));
        assertSame(small, at(0.5));
        at(3201);
        assertSame(small, at(0.5));
        assertNotSame(large, at(3200));
    }

    /** Each thread of a campaign begins with runs of one world. */
    @Test
    void threadsThatNeedTheSameCircuitFindItOnce() throws Exception {
        AtomicInteger searches = new AtomicInteger();
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch goal = new CountDownLatch(1);
        WallCircuits slow = new WallCircuits(setup -> {
            searches.incrementAndGet();
            begun.countDown();
            await(goal);
            return CarryOnMetrics.circuit(setup);
        });
        Call first = new Call(slow);
        await(begun);
        Call second = new Call(slow);
        second.awaitWaiting();
        goal.countDown();
        assertSame(first.circuit(), second.circuit());
        assertSame(first.circuit(), slow.forCarryOn(POLE));
        assertEquals(1, searches.get());
    }

    @Test
    void allThreadsThatWaitForASearchGetItsErrorAndALaterOneSearchesAgain() throws Exception {
        OutOfMemoryError full = new OutOfMemoryError("full");
        AtomicBoolean failed = new AtomicBoolean();
        CountDownLatch goal = new CountDownLatch(1);
        WallCircuits failing = new WallCircuits(setup -> {
            await(goal);
            if (!failed.getAndSet(true)) {
                throw full;
            }
            return CarryOnMetrics.circuit(setup);
        });
        Call first = new Call(failing);
        first.awaitWaiting();
        Call second = new Call(failing);
        second.awaitWaiting();
        goal.countDown();
        assertSame(full, first.failure());
        assertSame(full, second.failure());
        assertSame(failing.forCarryOn(POLE), failing.forCarryOn(POLE));
    }

    @Test
    void aThreadThatIsInterruptedWhileItWaitsEndsTheSearchOfNoOther() throws Exception {
        CountDownLatch goal = new CountDownLatch(1);
        WallCircuits slow = new WallCircuits(setup -> {
            await(goal);
            return CarryOnMetrics.circuit(setup);
        });
        Call first = new Call(slow);
        first.awaitWaiting();
        Call second = new Call(slow);
        second.awaitWaiting();
        second.thread.interrupt();
        assertInstanceOf(CancellationException.class, second.failure());
        goal.countDown();
        assertSame(first.circuit(), slow.forCarryOn(POLE));
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A thread that asks for the circuit of the pole. */
    private static final class Call {

        private final FutureTask<WallCircuit> task;
        private final Thread thread;

        Call(WallCircuits circuits) {
            task = new FutureTask<>(() -> circuits.forCarryOn(POLE));
            thread = new Thread(task);
            thread.setDaemon(true);
            thread.start();
        }

        void awaitWaiting() throws InterruptedException {
            while (thread.getState() != Thread.State.WAITING && thread.isAlive()) {
                Thread.sleep(1);
            }
        }

        WallCircuit circuit() throws Exception {
            return task.get();
        }

        Throwable failure() {
            return assertThrows(ExecutionException.class, task::get).getCause();
        }
    }
}
