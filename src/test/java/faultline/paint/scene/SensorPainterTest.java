package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import org.junit.jupiter.api.Test;

class SensorPainterTest {

    private static final Pose ROBOT = new Pose(3, 2, 0);

    private static RecordingSurface cone(SensorSnapshot sensor) {
        RecordingSurface drawn = new RecordingSurface();
        SensorPainter.paintCone(
                new DrawContext(drawn, new Camera(3, 2, 100, 400, 300), Palette.LIGHT, DrawContext.DEFAULT_FONT),
                0,
                sensor);
        return drawn;
    }

    @Test
    void theConeOfAFaultySensorIsPalerAndThatOfOneThatIsOffIsEmpty() {
        SensorSpec front = RobotSpec.DEFAULT.sensors().get(0);
        Fault stuck = new Fault.Stuck(0.4);
        Color fill = Palette.LIGHT.sensorColours(0).fill();
        Color outline = Palette.LIGHT.sensorColours(0).outline();
        RecordingSurface healthy = cone(SampleFrames.sensor(front, ROBOT, new Reading(0.5)));
        assertEquals(1, healthy.shapes(Palette.withAlpha(fill, 64)).size());
        assertEquals(2, healthy.shapes(outline).size(), "the outline and the reading");
        RecordingSurface faulty =
                cone(SampleFrames.faultySensor(front, ROBOT, new Reading(0.5), new Reading(0.4), stuck));
        assertEquals(1, faulty.shapes(Palette.withAlpha(fill, 26)).size());
        assertEquals(2, faulty.shapes(outline).size());
        assertFalse(faulty.shapes(Palette.withAlpha(outline, 150)).isEmpty(), "the hatching");
        RecordingSurface off =
                cone(SampleFrames.faultySensor(front, ROBOT, new Reading(0.5), new Reading(Reading.OFF), stuck));
        assertEquals(1, off.shapes(Palette.LIGHT.muted()).size());
        assertFalse(off.shapes(Palette.withAlpha(Palette.LIGHT.muted(), 150)).isEmpty(), "the hatching");
        assertTrue(off.shapes().stream().noneMatch(shape -> shape.startsWith("fill")), off.shapes()::toString);
    }
}
