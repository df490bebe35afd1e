package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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

    @Test
    void thePathHasTheColoursOfTheStatesAndOfFaults() throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("left-sensor-stuck.xml").setup();
        Frame frame;
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            for (int i = 0; i < 3500; i++) {
                simulation.tick();
            }
            frame = simulation.frame();
        }
        assertEquals(List.of(true, false, false, false), colours(frame, Layer.PATH));
        assertEquals(List.of(false, true, true, false), colours(frame, Layer.PATH_STATES));
        assertEquals(List.of(false, true, false, true), colours(frame, Layer.PATH_FAULTS), "grey without a fault");
    }

    /**
     * Returns whether the picture has the colours of the plain path, of SEARCH, which is grey, of FOLLOW, and of a
     * fault.
     */
    private static List<Boolean> colours(Frame frame, Layer layer) {
        Palette palette = Palette.DARK;
        BufferedImage image = new RenderRequest(
                        frame,
                        FrameRenderer.fitCamera(frame.snapshot(), 600, 400),
                        palette,
                        EnumSet.of(Layer.PATH, layer))
                .toImage(1);
        return Stream.of(
                        palette.path(),
                        PathStyle.stateColour(true, FollowerState.SEARCH.ordinal()),
                        PathStyle.stateColour(true, FollowerState.FOLLOW.ordinal()),
                        palette.contact())
                .map(colour -> count(image, colour) > 10)
                .toList();
    }

    private static long count(BufferedImage image, Color colour) {
        return IntStream.range(0, image.getWidth() * image.getHeight())
                .filter(i -> (image.getRGB(i % image.getWidth(), i / image.getWidth()) & 0xFFFFFF)
                        == (colour.getRGB() & 0xFFFFFF))
                .count();
    }
}
