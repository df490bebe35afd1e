package faultline.gui.document;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class WriteQueueTest {

    private final WriteQueue queue = new WriteQueue();
    private final List<String> order = Collections.synchronizedList(new ArrayList<>());

    @Test
    void aTaskStartsWhenTheOneBeforeHasEnded() {
        CountDownLatch gate = new CountDownLatch(1);
        runOnEdt(() -> {
            add("slow", gate);
            add("fast", new CountDownLatch(0));
        });
        Await.until("each task waits or has ended", WriteQueueTest::allWait);
        gate.countDown();
        Await.until("both outcomes", () -> order.size() == 4);
        // A task may start while the outcome of the one before is being passed on.
        assertEquals(List.of("slow", "fast"), only(List.of("slow", "fast")));
        assertEquals(List.of("slow done", "fast done"), only(List.of("slow done", "fast done")));
    }

    /** Returns some of the entries in their order. */
    private List<String> only(List<String> names) {
        return order.stream().filter(names::contains).toList();
    }

    @Test
    void aTaskThatFailsDoesNotStopTheNext() {
        runOnEdt(() -> {
            queue.add(
                    () -> {
                        throw new IllegalStateException("full");
                    },
                    result -> order.add("done"),
                    failure -> order.add(failure.getMessage()));
            add("next", new CountDownLatch(0));
        });
        Await.until("both outcomes", () -> order.size() == 3);
        assertEquals(List.of("next", "next done"), only(List.of("next", "next done")));
        assertTrue(order.contains("full"));
    }

    private void add(String name, CountDownLatch gate) {
        queue.add(
                () -> {
                    gate.await();
                    return order.add(name);
                },
                result -> order.add(name + " done"),
                failure -> order.add(failure.toString()));
    }

    private static boolean allWait() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("faultline-background"))
                .allMatch(thread -> thread.getState() == Thread.State.WAITING);
    }
}
