package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.geometry.Vector2;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import org.junit.jupiter.api.Test;

class CameraTest {

    private final Camera camera = new Camera(3, 2, 100, 800, 600);

    @Test
    void theCentreIsInTheMiddleOfThePictureAndYPointsUp() {
        assertEquals(new Vector2(400, 300), camera.toScreen(new Vector2(3, 2)));
        assertEquals(new Vector2(500, 200), camera.toScreen(new Vector2(4, 3)));
    }

    @Test
    void toWorldUndoesToScreen() {
        assertNear(new Vector2(1.25, 3.5), camera.toWorld(camera.toScreen(new Vector2(1.25, 3.5))), 1e-12);
    }

    @Test
    void theTransformEqualsToScreen() {
        Point2D moved = camera.transform().transform(new Point2D.Double(1.25, 3.5), new Point2D.Double());
        assertNear(camera.toScreen(new Vector2(1.25, 3.5)), new Vector2(moved.getX(), moved.getY()), 1e-9);
    }

    @Test
    void zoomingKeepsThePointUnderTheCursor() {
        Vector2 cursor = new Vector2(120, 450);
        Camera zoomed = camera.zoomedAbout(cursor, 3);
        assertEquals(300, zoomed.scale());
        assertNear(camera.toWorld(cursor), zoomed.toWorld(cursor), 1e-12);
    }

    @Test
    void zoomingStopsAtTheEndsOfTheScaleWithoutDrifting() {
        Vector2 cursor = new Vector2(120, 450);
        assertEquals(Camera.MAX_SCALE, camera.zoomedAbout(cursor, 1e9).scale());
        assertEquals(Camera.MIN_SCALE, camera.zoomedAbout(cursor, 1e-9).scale());
        Camera stopped = camera.zoomedAbout(cursor, 1e9);
        assertNear(stopped.toWorld(Vector2.ZERO), stopped.zoomedAbout(cursor, 2).toWorld(Vector2.ZERO), 1e-12);
    }

    @Test
    void panningMovesTheContentWithTheMouse() {
        Camera panned = camera.panned(30, 40);
        assertNear(
                camera.toScreen(new Vector2(1, 1)).plus(new Vector2(30, 40)), panned.toScreen(new Vector2(1, 1)), 1e-9);
    }

    @Test
    void fittingShowsTheBoundsAsLargeAsTheMarginAllows() {
        Camera fitted = Camera.fit(new Rectangle2D.Double(0, 0, 6, 4), 50, 800, 600);
        assertEquals(700 / 6.0, fitted.scale(), 1e-9);
        assertNear(new Vector2(50, 300 + 2 * 700 / 6.0), fitted.toScreen(Vector2.ZERO), 1e-9);
    }

    @Test
    void fittingIntoAnAreaShowsTheBoundsInItsMiddleAtTheRightScale() {
        Camera full = Camera.fit(new Rectangle2D.Double(-1, 2, 6, 4), new PixelRectangle(10, 20, 300, 200));
        assertEquals(50, full.scale(), 1e-9);
        assertEquals(new Rectangle(310, 220), full.bounds());
        assertNear(new Vector2(10, 220), full.toScreen(new Vector2(-1, 2)), 1e-9);
        assertNear(new Vector2(310, 20), full.toScreen(new Vector2(5, 6)), 1e-9);
        Camera wide = Camera.fit(new Rectangle2D.Double(-1, 2, 6, 4), new PixelRectangle(10.5, 20.25, 300, 100));
        assertEquals(25, wide.scale(), 1e-9);
        assertEquals(new Rectangle(311, 121), wide.bounds());
        assertNear(new Vector2(160.5, 70.25), wide.toScreen(new Vector2(2, 4)), 1e-9);
    }

    @Test
    void fittingIntoAnEmptyPictureStillReturnsACamera() {
        assertEquals(
                1 / 6.0,
                Camera.fit(new Rectangle2D.Double(0, 0, 6, 4), 50, 10, 10).scale());
    }

    @Test
    void theVisibleAreaLiesBetweenTheCorners() {
        assertEquals(new Rectangle2D.Double(-1, -1, 8, 6), camera.visibleArea());
    }

    @Test
    void aResizedPictureKeepsItsCentre() {
        assertEquals(new Vector2(100, 50), camera.resized(200, 100).toScreen(new Vector2(3, 2)));
    }

    @Test
    void aCameraWithoutPixelsIsRejected() {
        assertThrows(IllegalArgumentException.class, () -> new Camera(0, 0, 100, 0, 600));
        assertThrows(IllegalArgumentException.class, () -> new Camera(0, 0, Double.NaN, 800, 600));
    }

    private static void assertNear(Vector2 expected, Vector2 actual, double tolerance) {
        assertEquals(0, expected.distanceTo(actual), tolerance, expected + " and " + actual);
    }
}
