package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import java.math.BigDecimal;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The world of a map is as small as its bounding box, and contains its right and upper corners. */
class MapFrameTest {

    /** The step to which a size is rounded, metres. */
    private static final double STEP = 1e-6;

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
    void theWorldOfARotatedMapReachesItsOuterCornersAndEndsThere() {
        for (int degrees = 1; degrees < 360; degrees++) {
            MapFrame frame = frame(Math.toRadians(degrees));
            double right = 0;
            double upper = 0;
            for (int i = 0; i < 4; i++) {
                Vector2 corner = frame.lowerLeft().toParent(new Vector2(i % 2 * 2, i / 2 * 1.5));
                right = Math.max(right, corner.x());
                upper = Math.max(upper, corner.y());
            }
            String size = degrees + " degrees: " + frame + " for " + right + " x " + upper;
            assertTrue(right <= frame.width() && upper <= frame.height(), size);
            assertTrue(frame.width() <= right + 2 * STEP && frame.height() <= upper + 2 * STEP, size);
        }
    }
}
