package faultline.gui.batch;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
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

    /** Swing lists only children that are {@link Accessible}, whatever context they have. */
    @Test
    void screenReadersFindTheHistogram() {
        runOnEdt(() -> {
            HistogramView view = new HistogramView(quantity -> new double[] {0.25, 0.75});
            AccessibleContext context = view.getAccessibleContext();
            assertEquals(
                    List.of(view.getComponents()),
                    IntStream.range(0, context.getAccessibleChildrenCount())
                            .mapToObj(context::getAccessibleChild)
                            .toList());
        });
    }
}
