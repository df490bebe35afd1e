package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.Reading;
import faultline.world.SensorSnapshot;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class SensorPainterTest {

    private static final Pose ROBOT = new Pose(3, 2, 0);

    /** With the names of all of them, it would be wider than the picture. */
    @Test
    void theLabelOfASensorWithAllKindsOfFaultFitsIntoThePicture() {
        Fault[] faults = Stream.of(FaultKind.values())
                .map(kind -> kind.createFault(kind.defaultValue()))
                .toArray(Fault[]::new);
        SensorSnapshot sensor = SampleFrames.faultySensor(
                RobotSpec.DEFAULT.sensors().get(0), ROBOT, new Reading(0.5), new Reading(0.4), faults);
        BufferedImage picture = new BufferedImage(900, 600, BufferedImage.TYPE_INT_RGB);
        Camera camera = FrameRenderer.fitCamera(SampleFrames.frameOf(ROBOT).snapshot(), 900, 600);
        DrawContext context = new DrawContext(picture.createGraphics(), camera, Palette.LIGHT);
        List<SensorPainter.SensorLabel> labels = SensorPainter.labels(context, List.of(sensor), SceneLabels.ENGLISH);
        assertEquals(1, labels.size());
        assertTrue(new Rectangle2D.Double(0, 0, 900, 600).contains(labels.get(0).box()), labels::toString);
    }
}
