package faultline.paint.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
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
}
