package faultline.gui.batch;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
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

    @Test
    void theSummaryIsNotBehindTheChartInANarrowView() {
        runOnEdt(() -> {
            HistogramView view = new HistogramView(quantity -> new double[] {0.25, 0.75});
            view.setSize(300, 400);
            layOut(view);
            JLabel summary = ComponentFinder.findAll(view, JLabel.class)
                    .reduce((first, last) -> last)
                    .orElseThrow();
            int bottom = SwingUtilities.convertRectangle(summary.getParent(), summary.getBounds(), view).y
                    + summary.getPreferredSize().height;
            Component chart = ((BorderLayout) view.getLayout()).getLayoutComponent(BorderLayout.CENTER);
            assertTrue(bottom <= chart.getY(), bottom + " is in the chart, which begins at " + chart.getY());
        });
    }

    private static void layOut(Container part) {
        part.doLayout();
        Stream.of(part.getComponents()).filter(Container.class::isInstance).forEach(child -> layOut((Container) child));
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
