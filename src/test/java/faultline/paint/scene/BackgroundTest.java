package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.world.WaypointPath;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Grid, scale bar, bounds and routes in a picture of 400 x 300 pixels, 100 to the metre. */
class BackgroundTest {

    private static final Palette LIGHT = Palette.LIGHT;
    private static final Color ROUTE = LIGHT.movingOutline();

    private final RecordingSurface drawn = new RecordingSurface();

    private DrawContext around(double x, double y) {
        return new DrawContext(drawn, new Camera(x, y, 100, 400, 300), LIGHT, DrawContext.DEFAULT_FONT);
    }

    private List<Rectangle2D> bounds(Color colour) {
        return drawn.shapes(colour).stream()
                .map(shape -> shape.shape().getBounds2D())
                .toList();
    }

    private List<String> shapes(Color colour) {
        return drawn.shapes(colour).stream().map(Object::toString).toList();
    }

    private static Rectangle2D rectangle(double x, double y, double width, double height) {
        return new Rectangle2D.Double(x, y, width, height);
    }

    /** Major lines are a metre apart, the least nice distance of 80 pixels; the others a fifth of it. */
    @Test
    void theGridHasItsMajorLinesAtWholeMetres() {
        GridPainter.paint(around(0.5, 0.25));
        assertEquals(
                List.of(
                        rectangle(50, 0, 1, 300),
                        rectangle(150, 0, 1, 300),
                        rectangle(250, 0, 1, 300),
                        rectangle(350, 0, 1, 300),
                        rectangle(0, 275, 400, 1),
                        rectangle(0, 175, 400, 1),
                        rectangle(0, 75, 400, 1)),
                bounds(LIGHT.gridMajor()));
        assertEquals(20 + 15, bounds(LIGHT.grid()).size(), "from -1.4 to 2.4 and from -1.2 to 1.6 in steps of 0.2");
    }

    @Test
    void theScaleBarIsAMetreWithItsNameOnTheLeft() {
        DrawContext context = around(0, 0);
        ScaleBarPainter.paint(context);
        assertEquals(
                List.of("276.5,289.5 276.5,297.5 276.5,293.5 376.5,293.5 376.5,289.5 376.5,297.5"),
                shapes(LIGHT.text()));
        assertEquals(2, drawn.shapes().size(), "the bar and its halo");
        double name = 276.5 - 8 - context.measureText("1 m").getWidth();
        assertNear("1 m", name, 298, drawn.texts().get(0));
        Rectangle2D area = ScaleBarPainter.area(context);
        assertEquals(name, area.getMinX(), 1e-9);
        assertEquals(376.5, area.getMaxX(), 1e-9);
        assertEquals(293.5 - context.measureText("1 m").getHeight() / 2, area.getMinY(), 1e-9);
        assertEquals(300, area.getMaxY(), 1e-9);
    }

    /** Asserts that a text starts near a point, up to its side bearing and the height of its letters. */
    private static void assertNear(String text, double x, double y, String actual) {
        assertTrue(actual.startsWith(text + " at "), actual);
        String[] place = actual.substring(text.length() + 4).split(",");
        assertEquals(x, Double.parseDouble(place[0]), 2, actual);
        assertEquals(y, Double.parseDouble(place[1]), 2, actual);
    }

    @Test
    void aWallIsABandAroundTheWorldAndAnOpenWorldHasALine() {
        BoundsPainter.paint(around(1, 0.5), 2, 1, true);
        double band = BoundsPainter.BAND_WIDTH;
        assertEquals(
                List.of(
                        rectangle(100, 100, 200, 100),
                        rectangle(100 - band, 100 - band, 200 + 2 * band, 100 + 2 * band)),
                bounds(LIGHT.obstacleOutline()));
        assertEquals(
                List.of(rectangle(100 - band / 2, 100 - band / 2, 200 + band, 100 + band)), bounds(LIGHT.obstacle()));
        drawn.clear();
        BoundsPainter.paint(around(1, 0.5), 2, 1, false);
        assertEquals(List.of(rectangle(100, 100, 200, 100)), bounds(LIGHT.muted()));
        assertEquals(1, drawn.shapes().size());
    }

    private void paintRoute(boolean loop, Vector2... waypoints) {
        RoutePainter.paint(around(0, 0), new WaypointPath(0.1, loop, List.of(waypoints)), List.of());
    }

    /** The way back would fill the gaps between the dashes, so there is one line, but an arrow in each direction. */
    @Test
    void aRouteThereAndBackHasOneLineAndTwoArrows() {
        paintRoute(true, new Vector2(-1, 0), new Vector2(1, 0));
        List<String> shapes = shapes(ROUTE);
        assertEquals("100.0,150.0 300.0,150.0", shapes.get(0));
        assertEquals(6, shapes.size(), "also three dots");
        assertEquals("214.0,154.2 220.0,150.0 214.0,145.8", shapes.get(4));
        assertEquals("186.0,145.8 180.0,150.0 186.0,154.2", shapes.get(5));
    }

    @Test
    void aLoopEndsAtItsFirstPointAndAnotherRouteAtItsLast() {
        Vector2[] corners = {new Vector2(-1, 0), new Vector2(1, 0), new Vector2(1, 1)};
        paintRoute(true, corners);
        assertEquals(
                "100.0,150.0 300.0,150.0 300.0,50.0 100.0,150.0", shapes(ROUTE).get(0));
        assertEquals(1 + 4 + 3, shapes(ROUTE).size());
        drawn.clear();
        paintRoute(false, corners);
        assertEquals("100.0,150.0 300.0,150.0 300.0,50.0", shapes(ROUTE).get(0));
        assertEquals(1 + 3 + 2, shapes(ROUTE).size());
    }

    /** An obstacle that drives down has its left on the right in the picture; one that drives to the left, below. */
    @Test
    void theSpeedIsOnTheLeftOfTheLongestLeg() {
        paintRoute(false, new Vector2(0, 0), new Vector2(0.3, 0), new Vector2(0.3, -1.4));
        assertEquals(1, drawn.texts().size());
        assertNear("0.10 m/s", 230 + 4, 150 + 0.35 * 140 + 4.5, drawn.texts().get(0));
        drawn.clear();
        paintRoute(false, new Vector2(1, 0), new Vector2(-1, 0));
        Rectangle2D box = around(0, 0).measureText("0.10 m/s");
        double below = 150 + box.getHeight() / 2 + 4;
        assertNear(
                "0.10 m/s",
                300 - 0.35 * 200 - box.getWidth() / 2,
                below + 4.5,
                drawn.texts().get(0));
    }

    @Test
    void aShortLegHasNeitherArrowNorSpeed() {
        paintRoute(false, new Vector2(0, 0), new Vector2(0.23, 0));
        assertEquals(3, shapes(ROUTE).size(), "the line and two dots");
        assertEquals(List.of(), drawn.texts());
    }
}
