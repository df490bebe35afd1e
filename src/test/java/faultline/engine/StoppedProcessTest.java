package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.control.Controller;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.robot.RobotSpec;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A controller is not blamed for the time in which the machine stands still. */
class StoppedProcessTest {

    private static final double PATIENCE = 1;
    private static final int STOPS = 4;

    /** What one decision takes, so that most stops fall into one. */
    private static final long WORK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    /** Exchanges observations and decisions until its standard input ends. */
    static final class Exchange {

        private Exchange() {}

        public static void main(String[] args) throws Exception {
            Decision answer = new Decision(1, 2, Telemetry.ofState(ControllerState.of("TEST")));
            double[] readings = new double[8];
            Controller busy = observation -> {
                ThreadMXBean threads = ManagementFactory.getThreadMXBean();
                long begun = threads.getCurrentThreadCpuTime();
                while (threads.getCurrentThreadCpuTime() - begun < WORK_NANOS) {
                    Thread.onSpinWait();
                }
                return answer;
            };
            try (ControllerHost host = new ThreadedHost(busy, PATIENCE)) {
                System.out.print('s');
                System.out.flush();
                for (long tick = 0; System.in.available() == 0; tick++) {
                    host.submit(tick, 0.01, RobotSpec.DEFAULT, readings);
                    host.await();
                }
            }
            System.out.print('e');
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void aRunSurvivesThatItsProcessIsStoppedForLongerThanTheControllerMayTake() throws Exception {
        Process exchange = JavaProcess.builder(Exchange.class.getName(), List.of())
                .redirectErrorStream(true)
                .start();
        assertEquals('s', exchange.getInputStream().read());
        for (int i = 0; i < STOPS; i++) {
            JavaProcess.signal("-STOP", exchange.toHandle());
            TimeUnit.MILLISECONDS.sleep((long) (1200 * PATIENCE));
            JavaProcess.signal("-CONT", exchange.toHandle());
            TimeUnit.MILLISECONDS.sleep(50);
        }
        exchange.getOutputStream().write('.');
        exchange.getOutputStream().close();
        assertTrue(exchange.waitFor(60, TimeUnit.SECONDS));
        assertEquals("e", JavaProcess.output(exchange));
    }

    /** Interrupts a controller that returns only after its process was stopped for longer than it may take. */
    static final class Ending {

        private static final String STOP = "read line; kill -STOP $0; sleep 0.7; kill -CONT $0; echo";

        private Ending() {}

        public static void main(String[] args) throws Exception {
            Process shell = new ProcessBuilder(
                            "sh",
                            "-c",
                            STOP,
                            Long.toString(ProcessHandle.current().pid()))
                    .start();
            Controller slow = observation -> {
                try {
                    new CountDownLatch(1).await();
                } catch (InterruptedException ended) {
                    awaitStop(shell);
                }
                return new Decision(1, 2, Telemetry.ofState(ControllerState.of("TEST")));
            };
            try (ControllerHost host = new ThreadedHost(slow, 0.05)) {
                host.submit(0, 0.01, RobotSpec.DEFAULT, new double[8]);
                host.await();
            } catch (RunFailedException silent) {
                System.out.print(silent.getMessage());
            }
        }

        private static void awaitStop(Process shell) {
            try {
                shell.getOutputStream().write('\n');
                shell.getOutputStream().flush();
                shell.getInputStream().read();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void aControllerDoesNotIgnoreAnInterruptionThatItsProcessIsStoppedAfter() throws Exception {
        Process ending = JavaProcess.builder(Ending.class.getName(), List.of())
                .redirectErrorStream(true)
                .start();
        assertEquals("the controller has not answered for 0.05 s at tick 0", JavaProcess.output(ending));
    }
}
