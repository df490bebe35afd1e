package faultline.paint.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import faultline.paint.surface.PixelRectangle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** An area of 200 by 100 pixels whose left upper corner is at (30, 10). */
class PlotTest {

    private final Plot plot =
            new Plot(new PixelRectangle(30, 10, 200, 100), Axis.linear("x", 0, 50), new Axis("y", 1, 100, true));

    @ParameterizedTest
    @CsvSource({"0, 1, 30, 110", "50, 100, 230, 10", "10, 10, 70, 60"})
    void valuesIncreaseToTheRightAndUpwards(double x, double y, double left, double top) {
        assertEquals(left, plot.x(x), 1e-9);
        assertEquals(top, plot.y(y), 1e-9);
        Vector2 place = plot.toPicture(new Vector2(x, y));
        assertEquals(left, place.x(), 1e-9);
        assertEquals(top, place.y(), 1e-9);
    }

    @Test
    void fractionsBeginAtTheLowEnds() {
        assertEquals(new Vector2(0.2, 0), plot.toFractions(new Vector2(10, 1)));
    }
}
