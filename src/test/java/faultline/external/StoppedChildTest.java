package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A child is not blamed for the time in which the machine stands still. */
class StoppedChildTest {

    private static final double PATIENCE = 1;
    private static final int STOPS = 4;

    /** How long the child takes to answer, so that most stops fall into the wait for an answer. */
    private static final String ANSWER = "while read line; do sleep 0.05; echo \"$line\"; done";

    /** Exchanges lines with a child until its standard input ends. */
    static final class Exchange {

        private Exchange() {}

        public static void main(String[] args) throws Exception {
            try (ChildProcess child = new ChildProcess(List.of("sh", "-c", ANSWER), PATIENCE, line -> {})) {
                System.out.print('s');
                System.out.flush();
                while (System.in.available() == 0) {
                    child.send("line");
                    child.receive(PATIENCE);
                }
            }
            System.out.print('e');
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void aRunSurvivesThatItAndItsChildAreStoppedForLongerThanAnAnswerMayTake() throws Exception {
        Process exchange = JavaProcess.builder(Exchange.class.getName(), List.of())
                .redirectErrorStream(true)
                .start();
        assertEquals('s', exchange.getInputStream().read());
        for (int i = 0; i < STOPS; i++) {
            List<ProcessHandle> shells = exchange.children().toList();
            assertEquals(1, shells.size());
            // The child is stopped first and for the longest time, so that the run finds no answer when it continues.
            JavaProcess.signal("-STOP", shells.get(0));
            JavaProcess.signal("-STOP", exchange.toHandle());
            TimeUnit.MILLISECONDS.sleep((long) (1200 * PATIENCE));
            JavaProcess.signal("-CONT", exchange.toHandle());
            TimeUnit.MILLISECONDS.sleep(50);
            JavaProcess.signal("-CONT", shells.get(0));
            TimeUnit.MILLISECONDS.sleep(50);
        }
        exchange.getOutputStream().write('.');
        exchange.getOutputStream().close();
        assertTrue(exchange.waitFor(60, TimeUnit.SECONDS));
        assertEquals("e", JavaProcess.output(exchange));
    }
}
