package faultline.paint.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the ends and the labels of axes. */
class AxisTest {

    @ParameterizedTest
    @ValueSource(doubles = {1, -7.3, 1e3, 3e6, -3e6, 1e12})
    void theTicksAroundAValueAloneHaveDifferentLabels(double value) {
        Axis axis = Axis.covering("x", DoubleStream.of(value, value));
        assertTrue(axis.low() <= value && value <= axis.high());
        List<String> labels = axis.ticks().stream().map(axis::tickLabel).toList();
        assertTrue(labels.size() > 1);
        assertEquals(labels.size(), Set.copyOf(labels).size(), labels::toString);
    }

    /** An error of 0.2 mm alone, with an axis of at least 1 mm. */
    @Test
    void anAxisOfNumbersThatAreNotNegativeDoesNotStartBelowZero() {
        Axis axis = Axis.covering("x", DoubleStream.of(0.0002), 0.001);
        assertEquals(0, axis.low());
        assertEquals(0.001, axis.high(), 1e-12);
        assertEquals(
                -0.001, Axis.covering("x", DoubleStream.of(-0.0002, 0), 0.001).low(), 1e-12);
    }
}
