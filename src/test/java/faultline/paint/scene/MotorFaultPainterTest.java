package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import java.util.List;
import org.junit.jupiter.api.Test;

class MotorFaultPainterTest {

    private static final MotorFault WEAK = new MotorFault.Weak(0.7);
    private static final MotorFault LATE = new MotorFault.DeadBand(1);

    /** Paints the left wheels of a robot that looks to the right, and returns the shapes of the front one. */
    private static List<String> frontWheel(double scale, MotorFault... left) {
        RecordingSurface drawn = new RecordingSurface();
        MotorFaultPainter.paintWheels(
                new DrawContext(drawn, new Camera(2, 1, scale, 400, 300), Palette.LIGHT, DrawContext.DEFAULT_FONT),
                ScenePainterTest.withMotorFaults(new Pose(2, 1, 0), new MotorFaults(List.of(left), List.of()))
                        .snapshot());
        assertEquals(6, drawn.shapes().size(), "two wheels");
        return drawn.shapes().subList(0, 3);
    }

    /** A wheel is 75 mm long and 32 mm wide; the front one begins 30 mm ahead and 68 mm aside of the centre. */
    @Test
    void aWheelIsEnlargedAwayFromTheRobotToNineBySevenPixels() {
        assertEquals(
                "fill 215.0,116.0 252.5,116.0 252.5,100.0 215.0,100.0 215.0,116.0 closed",
                frontWheel(500, WEAK).get(0));
        String small = "200.6,148.6 209.6,148.6 209.6,141.6 200.6,141.6 200.6,148.6 closed";
        assertEquals("fill " + small, frontWheel(20, WEAK).get(0));
        assertEquals(small, frontWheel(20, WEAK).get(2));
    }

    @Test
    void theHatchingOfAWheelShowsItsFaults() {
        String across = "203.6,148.6 203.6,141.6 206.6,148.6 206.6,141.6";
        String along = "200.6,145.1 209.6,145.1";
        assertEquals(across, frontWheel(20, WEAK).get(1));
        assertEquals(along, frontWheel(20, LATE).get(1));
        assertEquals(across + " " + along, frontWheel(20, LATE, WEAK).get(1));
        assertEquals(
                "200.6,148.6 209.6,141.6 200.6,141.6 209.6,148.6",
                frontWheel(20, new MotorFault.NoDrive(), WEAK).get(1),
                "a dead one is only crossed out");
    }

    @Test
    void theLinesOfAHatchingAreAboutThreePixelsApart() {
        assertEquals(
                "209.0,136.4 209.0,129.4 212.0,136.4 212.0,129.4 215.0,136.4 215.0,129.4 218.0,136.4 218.0,129.4",
                frontWheel(200, WEAK).get(1));
        String along = frontWheel(500, LATE).get(1);
        assertTrue(along.startsWith("215.0,112.8 252.5,112.8 215.0,109.6 252.5,109.6 "), along);
    }
}
