package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.RobotPath;
import faultline.engine.SampleFrames;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
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

    /** Points along the x axis; 50 pixels are a metre, and the middle of the picture is the origin. */
    private static Vector2[] along(double... x) {
        return Arrays.stream(x).mapToObj(each -> new Vector2(each, 0)).toArray(Vector2[]::new);
    }

    private final RecordingSurface drawn = new RecordingSurface();

    private PathPainter.PaintedSection paint(RobotPath path, PathStyle style, int from, int most) {
        Camera camera = new Camera(0, 0, 50, 400, 300);
        DrawContext context = new DrawContext(drawn, camera, Palette.LIGHT, DrawContext.DEFAULT_FONT);
        return PathPainter.paint(context, path, style, from, most, camera.bounds());
    }

    @Test
    void linesOfTwoColoursMeet() {
        RobotPath path = SampleFrames.pathWithFault(3, along(0, 0.99, 1, 2, 3));
        paint(path, PathStyle.FAULTS, 0, Integer.MAX_VALUE);
        assertEquals(
                List.of("200.0,150.0 249.5,150.0 250.0,150.0", "250.0,150.0 300.0,150.0 350.0,150.0"), drawn.shapes());
        assertEquals(1, drawn.shapes(Palette.LIGHT.muted()).size());
    }

    @Test
    void pointsThatAlmostCoincideAreLeftOutButTheLastIsNot() {
        paint(SampleFrames.pathThrough(along(0, 0.01, 0.02, 0.03, 1, 1.01)), PathStyle.RUN, 0, Integer.MAX_VALUE);
        assertEquals(List.of("200.0,150.0 201.0,150.0 250.0,150.0 250.5,150.0"), drawn.shapes());
    }

    @Test
    void aSectionEndsWithTheLastOfItsPointsWhereTheNextBegins() {
        RobotPath path = SampleFrames.pathThrough(along(-1, 0, 1, 2, 3));
        PathPainter.PaintedSection first = paint(path, PathStyle.RUN, 0, 2);
        assertEquals(3, first.endIndex());
        assertEquals(2 + 2.0 / 8, first.cost(), "points that are not drawn cost an eighth");
        PathPainter.PaintedSection second = paint(path, PathStyle.RUN, first.endIndex() - 1, 100);
        assertEquals(path.size(), second.endIndex());
        assertEquals(
                List.of("150.0,150.0 200.0,150.0 250.0,150.0", "250.0,150.0 300.0,150.0 350.0,150.0"), drawn.shapes());
    }

    @Test
    void aLineThatCrossesTheViewIsDrawnWholeAndOneBesideItIsNot() {
        paint(SampleFrames.pathThrough(along(-9, 9)), PathStyle.RUN, 0, 100);
        assertEquals(List.of("-250.0,150.0 650.0,150.0"), drawn.shapes());
        drawn.clear();
        paint(SampleFrames.pathThrough(along(5, 9)), PathStyle.RUN, 0, 100);
        assertEquals(List.of(), drawn.shapes());
        // The edge of the line is 1 pixel inside the view.
        paint(SampleFrames.pathThrough(new Vector2(4.03, -1), new Vector2(4.03, 1)), PathStyle.RUN, 0, 100);
        assertEquals(List.of("401.5,200.0 401.5,100.0"), drawn.shapes());
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
