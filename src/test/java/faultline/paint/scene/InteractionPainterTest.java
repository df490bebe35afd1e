package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Selections and interactions in a picture of 400 x 300 pixels, 100 to the metre, with the origin in its middle. */
class InteractionPainterTest {

    private static final Palette LIGHT = Palette.LIGHT;
    private static final Camera CAMERA = new Camera(0, 0, 100, 400, 300);
    private static final Obstacle DISC = new Obstacle("disc", new ObstacleShape.CircleShape(0.5), new Pose(0, 0, 0));

    private final RecordingSurface drawn = new RecordingSurface();
    private final DrawContext context = new DrawContext(drawn, CAMERA, LIGHT, DrawContext.DEFAULT_FONT);

    private List<String> shapes(Color colour) {
        return drawn.shapes(colour).stream().map(Object::toString).toList();
    }

    /** Returns the middles of the handles, which have the colour of the canvas. */
    private List<String> handles() {
        return drawn.shapes(LIGHT.canvas()).stream()
                .map(handle -> handle.shape().getBounds2D())
                .map(bounds -> Math.round(bounds.getCenterX()) + "," + Math.round(bounds.getCenterY()))
                .toList();
    }

    @Test
    void aPreviewThatIsBlockedIsCrossedOut() {
        InteractionPainter.paintPreview(context, DISC, true);
        List<String> red = shapes(LIGHT.collision());
        assertEquals(3, red.size());
        assertEquals(List.of("150.0,100.0 250.0,200.0", "150.0,200.0 250.0,100.0"), red.subList(1, 3));
        drawn.clear();
        InteractionPainter.paintPreview(context, DISC, false);
        assertEquals(List.of(), shapes(LIGHT.collision()));
        assertEquals(1, shapes(LIGHT.accent()).size());
    }

    @Test
    void thePreviewOfSeveralObstaclesSurroundsAllOfThem() {
        InteractionPainter.paintPreview(
                context, ObstacleGroup.of(List.of(DISC, DISC.withPose(new Pose(1, 0.5, 0)))), false);
        assertEquals(
                new Rectangle2D.Double(150, 50, 200, 150),
                drawn.shapes(LIGHT.accent()).get(0).shape().getBounds2D());
    }

    /** The robot is 0.25 m long and 0.2 m wide, and looks up. */
    @Test
    void thePreviewOfTheRobotIsAroundItsPlatform() {
        Pose up = new Pose(1, 0.5, Math.PI / 2);
        for (boolean blocked : new boolean[] {false, true}) {
            drawn.clear();
            InteractionPainter.paintRobotPreview(context, RobotSpec.DEFAULT, up, blocked);
            Color colour = blocked ? LIGHT.collision() : LIGHT.accent();
            Rectangle2D bounds = drawn.shapes(colour).get(0).shape().getBounds2D();
            assertEquals(300, bounds.getCenterX(), 1e-9);
            assertEquals(100, bounds.getCenterY(), 1e-9);
            assertEquals(20, bounds.getWidth(), 1e-9);
            assertEquals(25, bounds.getHeight(), 1e-9);
            assertEquals(blocked ? 3 : 1, drawn.shapes(colour).size());
            assertFalse(drawn.shapes(LIGHT.robot()).isEmpty(), "the robot itself");
        }
    }

    @Test
    void valuesHaveABoxAroundThem() {
        InteractionPainter.paintValues(context, "1.00 m", ObstacleGroup.NONE, new Vector2(120, 60));
        Rectangle2D text = context.measureText("1.00 m");
        assertEquals(text.getWidth() + 16, box().getWidth(), 1e-9);
        assertEquals(text.getHeight() + 8, box().getHeight(), 1e-9);
    }

    @ParameterizedTest
    @CsvSource({"10, 20, 50, 80", "50, 20, 10, 80", "10, 80, 50, 20", "50, 80, 10, 20"})
    void aRubberBandCanBeDrawnFromAnyCorner(double fromX, double fromY, double toX, double toY) {
        InteractionPainter.paintRubberBand(context, new Vector2(fromX, fromY), new Vector2(toX, toY));
        String band = "10.0,20.0 50.0,20.0 50.0,80.0 10.0,80.0 ";
        assertEquals(2, drawn.shapes().size());
        assertTrue(drawn.shapes().get(0).startsWith("fill " + band), drawn.shapes()::toString);
        assertTrue(drawn.shapes().get(1).startsWith(band), drawn.shapes()::toString);
    }

    @Test
    void aSketchHasAHandleAtEachPointAndIsClosedOnlyAtItsFirst() {
        List<Vector2> points = List.of(new Vector2(0, 0), new Vector2(1, 0), new Vector2(1, 1));
        InteractionPainter.paintSketch(context, points, false);
        assertEquals("200.0,150.0 300.0,150.0 300.0,50.0", drawn.shapes().get(0));
        assertEquals(List.of("200,150", "300,150", "300,50"), handles());
        drawn.clear();
        InteractionPainter.paintSketch(context, points, true);
        assertEquals("200.0,150.0 300.0,150.0 300.0,50.0 closed", drawn.shapes().get(0));
    }

    private Rectangle2D box() {
        return drawn.shapes(LIGHT.canvas()).get(0).shape().getBounds2D();
    }

    @Test
    void valuesAreBelowTheObstacleOrElseBelowTheMouse() {
        Vector2 mouse = new Vector2(120, 60);
        InteractionPainter.paintValues(context, "1.00 m", ObstacleGroup.of(List.of(DISC)), mouse);
        assertEquals(200, box().getCenterX(), 1e-9);
        assertEquals(200 + 26, box().getCenterY(), 1e-9);
        assertTrue(drawn.texts().get(0).startsWith("1.00 m at "), drawn.texts()::toString);
        assertEquals(1, shapes(LIGHT.accent()).size());
        drawn.clear();
        InteractionPainter.paintRefusal(context, "no", ObstacleGroup.NONE, mouse);
        assertEquals(120, box().getCenterX(), 1e-9);
        assertEquals(60 + 26, box().getCenterY(), 1e-9);
        assertEquals(1, shapes(LIGHT.collision()).size());
    }

    @ParameterizedTest
    @CsvSource({"0, -40", "400, 300", "0, 300", "400, -40"})
    void valuesAreMovedIntoThePicture(double x, double y) {
        InteractionPainter.paintValues(context, "1.00 m, 2.00 m", ObstacleGroup.NONE, new Vector2(x, y));
        Rectangle2D box = box();
        assertEquals(x == 0 ? 0 : 400, x == 0 ? box.getMinX() : box.getMaxX(), 1e-9);
        assertEquals(y < 0 ? 0 : 300, y < 0 ? box.getMinY() : box.getMaxY(), 1e-9);
    }

    /** At heading 0 the handle is 24 pixels above the upper edge, which is 20 pixels above the middle. */
    @ParameterizedTest
    @CsvSource({"0, 200, 106", "90, 156, 150", "180, 200, 194", "-90, 244, 150"})
    void theHandleOfAnObstacleTurnsWithIt(double heading, double x, double y) {
        Obstacle box =
                new Obstacle("box", new ObstacleShape.RectangleShape(1, 0.4), new Pose(0, 0, Math.toRadians(heading)));
        Vector2 handle = SelectionPainter.handlePosition(CAMERA, box);
        assertEquals(0, handle.distanceTo(new Vector2(x, y)), 1e-9, handle::toString);
        SelectionPainter.paintHandles(context, box, List.of(new Vector2(1, 1)));
        assertEquals(List.of(Math.round(x) + "," + Math.round(y), "300,50"), handles());
    }

    @Test
    void theHandleOfSeveralObstaclesIsAboveTheHighestAtTheirCommonCentre() {
        ObstacleGroup both = ObstacleGroup.of(List.of(DISC, DISC.withPose(new Pose(1, 0.5, 0))));
        Vector2 handle = SelectionPainter.handlePosition(CAMERA, both);
        assertEquals(0, handle.distanceTo(new Vector2(250, 50 - 24)), 1e-9, handle::toString);
        SelectionPainter.paintHandle(context, both);
        assertEquals("250.0,125.0 250.0,26.0", drawn.shapes().get(0));
        assertEquals(List.of("250,26"), handles());
    }

    @Test
    void whatIsSelectedAndItsHandlesHaveOutlines() {
        SelectionPainter.paintOutline(context, DISC);
        assertEquals(
                new Rectangle2D.Double(150, 100, 100, 100),
                drawn.shapes(LIGHT.accent()).get(0).shape().getBounds2D());
        drawn.clear();
        SelectionPainter.paintSquareHandle(context, new Vector2(10, 20));
        assertEquals(box(), drawn.shapes(LIGHT.accent()).get(0).shape().getBounds2D());
        drawn.clear();
        SelectionPainter.paintCone(context, new Sector(new RigidMotion(1, 0, 0, 0), 0.8, 0.6, 1));
        Rectangle2D cone = drawn.shapes(LIGHT.accent()).get(0).shape().getBounds2D();
        assertEquals(100, cone.getWidth(), 1e-9);
        assertEquals(120, cone.getHeight(), 1e-9);
        assertEquals(1 + 3, drawn.shapes(LIGHT.accent()).size(), "the cone and its handles");
    }

    @Test
    void waypointsOutsideTheObstacleHaveHandles() {
        Obstacle moving = DISC.withMotion(
                new WaypointPath(0.1, false, List.of(new Vector2(0.2, 0), new Vector2(1, 1), new Vector2(-1, 1))));
        SelectionPainter.paintHandles(context, moving, List.of());
        assertEquals(List.of("200,76", "300,50", "100,50"), handles());
    }

    /** The cone is a quarter of a circle of 1 m around the x axis; its edges have handles at three quarters of it. */
    @Test
    void aConeHasHandlesOnItsArcAndOnBothEdges() {
        double half = Math.sqrt(0.5);
        SelectionPainter.paintCone(context, new Sector(new RigidMotion(1, 0, 0, 0), half, half, 1));
        long along = Math.round(75 * half);
        assertEquals(
                Stream.of("300,150", (200 + along) + "," + (150 - along), (200 + along) + "," + (150 + along))
                        .sorted()
                        .toList(),
                handles().stream().sorted().toList());
    }
}
