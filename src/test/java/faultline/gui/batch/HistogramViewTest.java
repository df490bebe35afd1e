package faultline.gui.batch;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class HistogramViewTest {

    @Test
    void aHiddenHistogramAsksForNoValues() {
        AtomicInteger requests = new AtomicInteger();
        runOnEdt(() -> {
            HistogramView view = new HistogramView(quantity -> {
                requests.incrementAndGet();
                return new double[] {0.25, 0.75};
            });
            view.update();
            view.update();
        });
        assertEquals(0, requests.get());
    }
}
