package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.RobotSpec;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class RobotPainterTest {

    private final RecordingSurface drawn = new RecordingSurface();
    /** A millimetre is a pixel, and the middle of the picture is the robot's. */
    private final DrawContext context =
            new DrawContext(drawn, new Camera(0, 0, 1000, 400, 300), Palette.LIGHT, DrawContext.DEFAULT_FONT);

    private static String bounds(RecordingSurface.DrawnShape drawn) {
        Rectangle2D box = drawn.shape().getBounds2D();
        return Math.round(box.getX()) + "," + Math.round(box.getY()) + " " + Math.round(box.getWidth()) + "x"
                + Math.round(box.getHeight());
    }

    /** The robot is 250 mm long and 200 mm wide. */
    @Test
    void theWheelsReachBeyondTheBodyWhoseFrontIsMarked() {
        RobotPainter.paint(context, RobotSpec.DEFAULT, new Pose(0, 0, 0));
        List<String> wheels = List.of("230,50 75x32", "230,218 75x32", "95,50 75x32", "95,218 75x32");
        List<String> frontAndArrow = List.of("300,100 15x100", "225,116 60x68");
        String body = "75,72 250x155";
        assertEquals(
                Stream.of(wheels, frontAndArrow, List.of(body))
                        .flatMap(List::stream)
                        .toList(),
                drawn.shapes(Palette.LIGHT.robotOutline()).stream()
                        .map(RobotPainterTest::bounds)
                        .toList());
        assertEquals(
                List.of(body),
                drawn.shapes(Palette.LIGHT.robot()).stream()
                        .map(RobotPainterTest::bounds)
                        .toList());
    }

    @Test
    void theHaloIsAFilledDiscWithARing() {
        RobotPainter.paintHalo(context, RobotSpec.DEFAULT, new Pose(0, 0, 0));
        double radius = 1000 * Math.hypot(0.25, 0.2) / 2 + 11;
        assertTrue(drawn.shapes().get(0).startsWith("fill "));
        assertEquals(3, drawn.shapes().size());
        assertEquals(
                2 * radius,
                drawn.shapes(Palette.LIGHT.robot()).get(0).shape().getBounds2D().getWidth(),
                1e-9);
    }
}
