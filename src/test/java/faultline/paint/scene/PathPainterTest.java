package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Palette;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class PathPainterTest {

    /**
     * The path leads from above the centre of the world far to the right and back to below the centre. The points
     * outside are skipped in blocks.
     */
    @Test
    void linesThatLeaveTheViewAreDrawnToItsEdge() {
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i < 64; i++) {
            points.add(new Vector2(3, 2 + 0.01 * i));
        }
        for (int i = 0; i < 128; i++) {
            points.add(new Vector2(50 + i, i < 64 ? 2.63 : 1));
        }
        points.add(new Vector2(3, 1));
        Frame frame = SampleFrames.frameOf(
                new Pose(1, 1, 0), SampleFrames.pathThrough(points.toArray(Vector2[]::new)), List.of());
        Pixels picture = Pixels.render(frame, Palette.LIGHT);
        assertTrue(picture.hasNear(Palette.LIGHT.path(), new Vector2(4.5, 2.63), 3), "on the way out");
        assertTrue(picture.hasNear(Palette.LIGHT.path(), new Vector2(4.5, 1), 3), "on the way back");
    }
}
