package faultline.gui.document;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

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
        assertEquals(List.of("slow", "slow done", "fast", "fast done"), order);
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
        assertEquals(List.of("full", "next", "next done"), order);
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
