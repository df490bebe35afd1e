package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.gui.BackgroundThreads;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class BackgroundPollTest {

    @Test
    void whileAPollWaitsNoOtherBegins() {
        BackgroundPoll poll = new BackgroundPoll();
        CountDownLatch answer = new CountDownLatch(1);
        List<Object> results = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            int number = i;
            runOnEdt(() -> poll.compute(
                    () -> {
                        answer.await();
                        return number;
                    },
                    results::add,
                    failure -> {}));
        }
        assertEquals(1, BackgroundThreads.count());
        answer.countDown();
        BackgroundThreads.awaitEnd();
        assertEquals(List.of(0), callOnEdt(() -> List.copyOf(results)));
        assertFalse(callOnEdt(poll::isActive));
    }

    @Test
    void afterAFailureTheNextPollBegins() {
        BackgroundPoll poll = new BackgroundPoll();
        List<String> failures = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            runOnEdt(() -> poll.compute(
                    () -> {
                        throw new IllegalStateException("no answer");
                    },
                    result -> {},
                    failure -> failures.add(failure.getMessage())));
            BackgroundThreads.awaitEnd();
        }
        assertEquals(List.of("no answer", "no answer"), callOnEdt(() -> List.copyOf(failures)));
    }
}
