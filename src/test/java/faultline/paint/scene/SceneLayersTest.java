package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.awt.Color;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SceneLayersTest {

    private static final Set<Layer> ALL = EnumSet.allOf(Layer.class);

    /** A frame that has something in every layer. */
    private static Frame frame() {
        Pose robot = new Pose(2, 1, 0);
        SensorSpec front = new SensorSpec("front", Vector2.ZERO, 0, 0.8, 0.5, true, 0);
        ObstacleShape disc = new ObstacleShape.CircleShape(0.3);
        WaypointPath motion = new WaypointPath(0.2, false, List.of(new Vector2(3, 3), new Vector2(5, 3)));
        return SampleFrames.frameOf(
                robot,
                SampleFrames.pathThrough(new Vector2(1, 1), robot.position()),
                List.of(SampleFrames.sensor(front, robot, SampleFrames.NOTHING, new Vector2(2.5, 1))),
                new Obstacle("pole", disc, new Pose(1, 3, 0)),
                new Obstacle("visitor", disc, new Pose(4, 2, 0), motion));
    }

    private static RecordingSurface painted(Set<Layer> layers) {
        RecordingSurface drawn = new RecordingSurface();
        Frame frame = frame();
        DrawContext context = new DrawContext(
                drawn, FrameRenderer.fitCamera(frame.snapshot(), 900, 600), Palette.LIGHT, DrawContext.DEFAULT_FONT);
        new ScenePainter(layers, SceneLabels.ENGLISH).paint(context, frame, List.of(SampleReferenceOverlays.office()));
        return drawn;
    }

    private static int count(RecordingSurface drawn) {
        return drawn.shapes().size() + drawn.texts().size();
    }

    @ParameterizedTest
    @EnumSource(
            value = Layer.class,
            mode = EnumSource.Mode.EXCLUDE,
            names = {"PATH_STATES", "PATH_FAULTS"})
    void aLayerIsPaintedOnlyIfItIsShown(Layer layer) {
        int without = count(painted(EnumSet.complementOf(EnumSet.of(layer))));
        assertTrue(count(painted(ALL)) > without);
    }

    @Test
    void theGhostHasItsPathOnlyIfPathsAreShown() {
        int without = painted(EnumSet.complementOf(EnumSet.of(Layer.PATH)))
                .shapes(Palette.LIGHT.reference())
                .size();
        assertTrue(without > 0, "the ghost itself");
        assertEquals(without + 1, painted(ALL).shapes(Palette.LIGHT.reference()).size());
    }

    @Test
    void everyObstacleIsPaintedOnce() {
        RecordingSurface drawn = painted(EnumSet.noneOf(Layer.class));
        assertEquals(1, discs(drawn, Palette.LIGHT.obstacleOutline()));
        assertEquals(1, discs(drawn, Palette.LIGHT.movingOutline()));
    }

    /** Counts the shapes that are as wide as high, as the bounds of the world are not. */
    private static long discs(RecordingSurface drawn, Color colour) {
        return drawn.shapes(colour).stream()
                .map(each -> each.shape().getBounds2D())
                .filter(box -> Math.abs(box.getWidth() - box.getHeight()) < 1e-6)
                .count();
    }
}
