package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The world of a map is its bounding box, and contains its right and upper corners. */
class MapFrameTest {

    /** The step to which a size is rounded, metres. */
    private static final double STEP = 1e-6;

    /** A sum of two coordinates is rounded by less, metres. */
    private static final double ROUNDING = 1e-12;

    private static MapFrame frame(double yaw) {
        return MapFrame.of(
                new MapDescription(Path.of("m.pgm"), new BigDecimal("0.05"), yaw, MapMode.TRINARY, false, 0.65, 0.196),
                40,
                30);
    }

    @Test
    void aMapThatIsNotRotatedIsItsWorld() {
        assertEquals(new MapFrame(new Pose(0, 0, 0), 2, 1.5), frame(0));
    }

    @Test
    void theWorldOfARotatedMapBeginsAndEndsWithItsCorners() {
        for (int degrees = 1; degrees < 360; degrees++) {
            MapFrame frame = frame(Math.toRadians(degrees));
            List<Vector2> corners = Stream.of(
                            new Vector2(0, 0), new Vector2(2, 0), new Vector2(2, 1.5), new Vector2(0, 1.5))
                    .map(frame.lowerLeft()::toParent)
                    .toList();
            assertTrue(Double.compare(frame.lowerLeft().x(), 0) >= 0, "-0 is never written");
            assertTrue(Double.compare(frame.lowerLeft().y(), 0) >= 0, "-0 is never written");
            String size = degrees + " degrees: " + frame + " for " + corners;
            assertSpan(frame.width(), corners.stream().mapToDouble(Vector2::x).summaryStatistics(), size);
            assertSpan(frame.height(), corners.stream().mapToDouble(Vector2::y).summaryStatistics(), size);
        }
    }

    @Test
    void theWorldOfATinyRotatedMapIsTiny() {
        MapDescription cells = new MapDescription(
                Path.of("m.pgm"), new BigDecimal("0.001"), Math.PI / 2, MapMode.TRINARY, false, 0.65, 0.196);
        MapFrame frame = MapFrame.of(cells, 40, 30);
        assertEquals(0.03, frame.width(), 2 * STEP);
        assertEquals(0.04, frame.height(), 2 * STEP);
    }

    private static void assertSpan(double size, DoubleSummaryStatistics corners, String message) {
        assertTrue(corners.getMin() > -ROUNDING && corners.getMin() < STEP, message);
        assertTrue(corners.getMax() <= size && size <= corners.getMax() + 2 * STEP, message);
    }
}
