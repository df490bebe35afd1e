package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.JavaProcess;
import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A run that somebody waits for is not ended because the machine stood still. */
class StoppedSessionTest {

    /** Decides after its process was stopped for longer than a tick may keep somebody waiting. */
    private static final class Stopped implements ControllerSource {

        private static final String STOP =
                "read line; kill -STOP $0; sleep 1.2; kill -CONT $0; sleep 0.2; echo; read line";

        private final CountDownLatch asked = new CountDownLatch(1);
        private final CountDownLatch awaited = new CountDownLatch(1);

        @Override
        public Controller start(RunConditions run) {
            return observation -> {
                asked.countDown();
                try {
                    awaited.await();
                    if (observation.tick() == 0) {
                        stop();
                    }
                } catch (IOException | InterruptedException e) {
                    throw new IllegalStateException(e);
                }
                return new Decision(1, 1, Telemetry.ofState(FollowerState.SEARCH));
            };
        }

        private static void stop() throws IOException {
            Process shell = new ProcessBuilder(
                            "sh",
                            "-c",
                            STOP,
                            Long.toString(ProcessHandle.current().pid()))
                    .start();
            shell.getOutputStream().write('\n');
            shell.getOutputStream().flush();
            shell.getInputStream().read();
        }

        @Override
        public boolean limitsAnswerTime() {
            return false;
        }
    }

    /** Prints how a run fares whose process is stopped during a tick. */
    static final class Program {

        private Program() {}

        public static void main(String[] args) throws Exception {
            Stopped controller = new Stopped();
            try (Session session = Session.start(Scenario.loadShipped("yard.xml")
                    .setup()
                    .withController(new ControllerSpec.Chosen(new ControllerSpec.Extern(0), controller)))) {
                session.step();
                controller.asked.await();
                session.stopWaiting();
                controller.awaited.countDown();
                session.journal().get();
                System.out.print(
                        session.status().failure().map(Object::toString).orElse("alive"));
            }
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void aTickDuringWhichTheProcessIsStoppedIsNotInterrupted() throws Exception {
        Process program = JavaProcess.builder(Program.class.getName(), List.of())
                .redirectErrorStream(true)
                .start();
        assertEquals("alive", JavaProcess.output(program));
    }
}
