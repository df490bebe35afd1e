package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Routes in a picture of 1200 x 800 pixels, 10 to the metre, with the origin in its middle. */
class LongRouteTest {

    private static final Palette LIGHT = Palette.LIGHT;
    private static final Camera CAMERA = new Camera(0, 0, 10, 1200, 800);
    private static final int LONG = 10_000;

    private final RecordingSurface drawn = new RecordingSurface();
    private final DrawContext context = new DrawContext(drawn, CAMERA, LIGHT, DrawContext.DEFAULT_FONT);

    /** A route all over the picture, and beyond its edges. */
    private static WaypointPath random(int size) {
        Random random = new Random(1);
        return route(IntStream.range(0, size)
                .mapToObj(i -> new Vector2(140 * random.nextDouble() - 70, 100 * random.nextDouble() - 50))
                .toList());
    }

    private static WaypointPath route(List<Vector2> waypoints) {
        return new WaypointPath(0.1, false, waypoints);
    }

    /** A route that begins with many points far to the right of the picture. */
    private static WaypointPath mostlyOutside(Vector2... waypoints) {
        return route(Stream.concat(
                        Stream.iterate(new Vector2(100, 0), point -> point.plus(new Vector2(5, 0)))
                                .limit(LONG),
                        Stream.of(waypoints))
                .toList());
    }

    private static Obstacle moving(WaypointPath motion) {
        return new Obstacle("disc", new ObstacleShape.CircleShape(0.5), new Pose(0, 0, 0)).withMotion(motion);
    }

    private List<String> paintRoute(WaypointPath motion) {
        drawn.clear();
        RoutePainter.paint(context, motion, List.of());
        return drawn.shapes();
    }

    private List<String> paintHandles(WaypointPath motion) {
        drawn.clear();
        SelectionPainter.paintHandles(context, moving(motion), List.of());
        // Without the handle that rotates the obstacle.
        return drawn.shapes().subList(3, drawn.shapes().size());
    }

    private static void assertQuick(WaypointPath motion) {
        BufferedImage image = new BufferedImage(CAMERA.width(), CAMERA.height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        DrawContext pixels = new DrawContext(graphics, CAMERA, LIGHT);
        CpuTime time = CpuTime.start();
        RoutePainter.paint(pixels, motion, List.of());
        SelectionPainter.paintHandles(pixels, moving(motion), List.of());
        time.assertBelow(0.3);
        graphics.dispose();
    }

    @Test
    void aPictureWithALongRouteTakesLittleTime() {
        assertQuick(random(LONG));
        assertQuick(mostlyOutside());
        assertQuick(route(Collections.nCopies(LONG, new Vector2(1, 1))));
    }

    @Test
    void aRouteOfAtMost500PointsHasAllItsDashesDotsArrowsAndHandles() {
        List<Vector2> waypoints = new ArrayList<>(random(499).waypoints());
        waypoints.add(waypoints.get(498));
        List<String> shapes = paintRoute(route(waypoints));
        assertEquals(500, shapes.get(0).split(" ").length);
        assertEquals(
                500, shapes.stream().filter(shape -> shape.startsWith("fill")).count());
        assertEquals(2 * 500, paintHandles(route(waypoints)).size());
    }

    @Test
    void aCrowdedRouteIsOneLineAndItsHandlesAreSquares() {
        List<Vector2> waypoints = IntStream.range(0, 501)
                .mapToObj(i -> new Vector2(0.1 * i, i % 2 == 0 ? 5 : 6))
                .toList();
        List<String> shapes = paintRoute(route(waypoints));
        assertEquals(1, shapes.size());
        assertTrue(shapes.get(0).startsWith("600.0,350.0 601.0,340.0 602.0,350.0 "), shapes.get(0));
        assertEquals(501, shapes.get(0).split(" ").length);
        List<String> handles = paintHandles(route(waypoints));
        assertEquals(2 * 501, handles.size());
        assertEquals("fill 597.0,347.0 604.0,347.0 604.0,354.0 597.0,354.0 597.0,347.0 closed", handles.get(0));
        assertEquals("fill 598.0,348.0 603.0,348.0 603.0,353.0 598.0,353.0 598.0,348.0 closed", handles.get(1));
    }

    @Test
    void legsBesideThePictureAreLeftOut() {
        WaypointPath motion = mostlyOutside(
                new Vector2(70, 10), new Vector2(0, 10), new Vector2(0, 60), new Vector2(0, 70), new Vector2(-70, 0));
        assertEquals(
                List.of("1300.0,300.0 600.0,300.0 600.0,-200.0", "600.0,-300.0 -100.0,400.0"),
                linesOf(motion),
                "the last leg cuts a corner of the picture");
        assertEquals(List.of(), paintRoute(mostlyOutside()));
        assertEquals(2, paintHandles(motion).size(), "only the second of the points is in the picture");
    }

    /** Returns the lines of a route, without its dots and arrows, which are small. */
    private List<String> linesOf(WaypointPath motion) {
        paintRoute(motion);
        return drawn.shapes(LIGHT.movingOutline()).stream()
                .filter(shape -> !shape.filled() && shape.shape().getBounds2D().getWidth() > 100)
                .map(Object::toString)
                .toList();
    }

    @Test
    void pointsThatAlmostCoincideAreOneDotAndOneHandle() {
        List<Vector2> waypoints = new ArrayList<>(Collections.nCopies(LONG, new Vector2(5, 5)));
        waypoints.add(new Vector2(5.05, 5));
        waypoints.add(new Vector2(15, 5));
        assertEquals("650.0,350.0 750.0,350.0", paintRoute(route(waypoints)).get(0));
        assertEquals(1 + 2 + 1, drawn.shapes().size(), "a line, two dots and an arrow");
        assertEquals(2 * 2, paintHandles(route(waypoints)).size());
    }
}
