package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Both hosts exchange observations and decisions by the same contract. */
@Timeout(value = 1, unit = TimeUnit.MINUTES)
class ControllerHostTest {

    private static final Observation AT_TICK_7 = new Observation(7, 0.01, RobotSpec.DEFAULT, new double[8]);

    private static final Decision ANSWER = new Decision(1, 2, Telemetry.ofState(ControllerState.of("TEST")));

    @ParameterizedTest
    @EnumSource(ControllerMode.class)
    void theDecisionOnTheObservationComesBack(ControllerMode mode) {
        Decision decision = new Decision(1, 2, Telemetry.ofState(ControllerState.of("TEST")));
        try (ControllerHost host = ControllerHost.create(observation -> decision, mode)) {
            submit(host);
            assertEquals(decision, host.await());
        }
    }

    @ParameterizedTest
    @EnumSource(ControllerMode.class)
    void aControllerThatThrowsEndsTheRunWithASentence(ControllerMode mode) {
        Controller broken = observation -> {
            throw new IllegalStateException("no wheels");
        };
        try (ControllerHost host = ControllerHost.create(broken, mode)) {
            submit(host);
            RunFailedException failure = assertThrows(RunFailedException.class, host::await);
            assertEquals(
                    "the controller broke at tick 7: java.lang.IllegalStateException: no wheels", failure.getMessage());
        }
    }

    @ParameterizedTest
    @EnumSource(ControllerMode.class)
    void aControllerThatGivesNoReasonForItsStateEndsTheRunWithASentence(ControllerMode mode) {
        Controller broken = observation -> Decision.ofVelocity(observation.robot(), new Velocity(0.1, 0), "HERE", null);
        try (ControllerHost host = ControllerHost.create(broken, mode)) {
            submit(host);
            RunFailedException failure = assertThrows(RunFailedException.class, host::await);
            assertEquals(
                    "the controller broke at tick 7: java.lang.NullPointerException: the why of the decision is null;"
                            + " it may be empty",
                    failure.getMessage());
        }
    }

    @Test
    void aLongExceptionIsCutOff() {
        String message = RunFailedException.ofController(7, new IllegalStateException("x".repeat(1_000_000)))
                .getMessage();
        assertTrue(message.startsWith("the controller broke at tick 7: java.lang.IllegalStateException: xxx"));
        assertTrue(message.endsWith("xxx..."));
        assertTrue(message.length() < 500);
    }

    @Test
    void anExceptionIsGivenWithTheInnermostPlaceInTheControllersCode() {
        IllegalStateException thrown = new IllegalStateException("lost");
        StackTraceElement inJdk = new StackTraceElement("", "java.base", "17", "java.util.List", "get", "List.java", 3);
        StackTraceElement inProgram = new StackTraceElement("faultline.robot.RobotSpec", "sensor", "RobotSpec.java", 4);
        StackTraceElement inController = new StackTraceElement("own.WallBot", "decide", "WallBot.java", 17);
        StackTraceElement outside = new StackTraceElement("own.WallBot", "drive", "WallBot.java", 9);
        thrown.setStackTrace(new StackTraceElement[] {inJdk, inProgram, inController, outside});
        assertEquals(
                "the controller broke at tick 7: java.lang.IllegalStateException: lost"
                        + " at own.WallBot.decide(WallBot.java:17)",
                RunFailedException.ofController(7, thrown).getMessage());
    }

    /** A class that cannot be initialised. */
    private static final class BrokenTable {
        private static final int SIZE = Integer.parseInt("none");
    }

    @Test
    void aClassThatCannotBeInitialisedIsReportedWithTheReasonAtEachUse() {
        Controller broken = observation -> new Decision(BrokenTable.SIZE, 0, ANSWER.telemetry());
        List<String> reasons = List.of(
                "the controller broke at tick 7: java.lang.NumberFormatException: For input string: \"none\"",
                "the controller broke at tick 7: java.lang.ExceptionInInitializerError: Exception"
                        + " java.lang.NumberFormatException: For input string: \"none\" [in thread");
        for (String reason : reasons) {
            try (ControllerHost host = ControllerHost.create(broken, ControllerMode.OWN_THREAD)) {
                submit(host);
                String failure =
                        assertThrows(RunFailedException.class, host::await).getMessage();
                assertTrue(failure.startsWith(reason), failure);
            }
        }
    }

    @Test
    void theCauseOfAnExceptionWithoutAMessageIsGivenWithItsPlace() {
        IllegalStateException cause = new IllegalStateException("no table");
        cause.setStackTrace(new StackTraceElement[] {new StackTraceElement("own.Table", "load", "Table.java", 5)});
        assertEquals(
                "the controller broke at tick 7: java.lang.IllegalStateException: no table"
                        + " at own.Table.load(Table.java:5)",
                RunFailedException.ofController(7, new ExceptionInInitializerError(cause))
                        .getMessage());
        IllegalStateException own = new IllegalStateException("lost", cause);
        own.setStackTrace(new StackTraceElement[0]);
        assertEquals(
                "the controller broke at tick 7: java.lang.IllegalStateException: lost",
                RunFailedException.ofController(7, own).getMessage());
    }

    /** An exception whose text cannot be read. */
    static final class Unspeakable extends RuntimeException {
        private static final long serialVersionUID = 1L;

        @Override
        public String getMessage() {
            throw new IllegalStateException("no words");
        }
    }

    @ParameterizedTest
    @EnumSource(ControllerMode.class)
    void anExceptionThatCannotBeReadIsNamedByItsClass(ControllerMode mode) {
        Controller broken = observation -> {
            throw new Unspeakable();
        };
        try (ControllerHost host = ControllerHost.create(broken, mode)) {
            submit(host);
            RunFailedException failure = assertThrows(RunFailedException.class, host::await);
            assertEquals(
                    "the controller broke at tick 7: " + Unspeakable.class.getName() + ", whose text cannot be read",
                    failure.getMessage());
        }
    }

    /** An exception whose text takes for ever. */
    static final class Endless extends RuntimeException {
        private static final long serialVersionUID = 1L;

        @Override
        public String getMessage() {
            ControllerProvidersTest.waitForEver();
            return "never";
        }
    }

    @Test
    void anExceptionWhoseTextTakesForEverEndsTheRunAsAControllerThatDoesNotAnswer() {
        Controller broken = observation -> {
            throw new Endless();
        };
        try (ControllerHost host = new ThreadedHost(broken, 0.05)) {
            submit(host);
            RunFailedException failure = assertThrows(RunFailedException.class, host::await);
            assertEquals("the controller has not answered for 0.05 s at tick 7", failure.getMessage());
        }
    }

    private static void submit(ControllerHost host) {
        host.submit(AT_TICK_7.tick(), AT_TICK_7.dt(), AT_TICK_7.robot(), AT_TICK_7.readings());
    }

    @Test
    void aControllerThatDoesNotAnswerEndsTheRunAndNothingIsPutInItsPlace() {
        CountDownLatch never = new CountDownLatch(1);
        Controller silent = observation -> {
            try {
                never.await();
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
            return new Decision(0, 0, Telemetry.ofState(ControllerState.of("LATE")));
        };
        try (ControllerHost host = new ThreadedHost(silent, 0.05)) {
            submit(host);
            RunFailedException failure = assertThrows(RunFailedException.class, host::await);
            assertEquals("the controller has not answered for 0.05 s at tick 7", failure.getMessage());
        }
    }

    @Test
    void aControllerThatIgnoresInterruptionIsNamedAndDisturbsNoOtherRun() throws InterruptedException {
        AtomicReference<Thread> busy = new AtomicReference<>();
        AtomicBoolean released = new AtomicBoolean();
        Controller deaf = observation -> {
            busy.set(Thread.currentThread());
            while (!released.get()) {
                Thread.yield();
            }
            return ANSWER;
        };
        try (ControllerHost host = new ThreadedHost(deaf, 0.05)) {
            submit(host);
            RunFailedException failure = assertThrows(RunFailedException.class, host::await);
            assertEquals(
                    "the controller has not answered for 0.05 s at tick 7; it ignores interruption, so its thread"
                            + " continues until the program ends",
                    failure.getMessage());
        }
        assertTrue(busy.get().isAlive() && busy.get().isDaemon(), "the process can end all the same");
        try (ControllerHost next = ControllerHost.create(observation -> ANSWER, ControllerMode.OWN_THREAD)) {
            submit(next);
            assertEquals(ANSWER, next.await());
        }
        released.set(true);
        busy.get().join();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aControllerIsNoLongerCalledWhenItsHostIsClosed(boolean interrupted) throws InterruptedException {
        Thread closing = Thread.currentThread();
        CountDownLatch begun = new CountDownLatch(1);
        AtomicBoolean returned = new AtomicBoolean();
        Controller slow = observation -> {
            begun.countDown();
            waitUntilInterrupted();
            while (closing.getState() != Thread.State.TIMED_WAITING) {
                Thread.onSpinWait();
            }
            returned.set(true);
            return ANSWER;
        };
        try (ControllerHost host = ControllerHost.create(slow, ControllerMode.OWN_THREAD)) {
            submit(host);
            begun.await();
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
        assertEquals(interrupted, Thread.interrupted());
        assertTrue(returned.get());
    }

    private static void waitUntilInterrupted() {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException ended) {
            // Expected; the thread ends when the host waits for it.
        }
    }

    @Test
    void itsOwnThreadIsNotTheSimulationThread() {
        AtomicReference<Thread> thread = new AtomicReference<>();
        Controller nosy = observation -> {
            thread.set(Thread.currentThread());
            return new Decision(0, 0, Telemetry.ofState(ControllerState.of("TEST")));
        };
        try (ControllerHost host = ControllerHost.create(nosy, ControllerMode.OWN_THREAD)) {
            submit(host);
            host.await();
            assertNotEquals(Thread.currentThread(), thread.get());
        }
    }
}
