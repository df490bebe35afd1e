package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

class SensorViewTest {

    private static final double EXACT = 1e-12;
    private static final double QUARTER_TURN = Math.PI / 2;

    private static SensorView view(Vector2 mountPosition, double bearing, double halfConeDegrees, double reading) {
        return new SensorView(mountPosition, bearing, Math.toRadians(halfConeDegrees), 0.8, reading, true);
    }

    @Test
    void aWallAcrossTheAxisIsAsFarFromTheCentreAsMountAndReadingTogether() {
        assertEquals(0.35, view(new Vector2(0, 0.1), QUARTER_TURN, 10, 0.25).perpendicularDistance(), EXACT);
    }

    @Test
    void aWallWhoseFootLiesInTheConeIsAsFarAsTheReading() {
        assertEquals(0.25, view(Vector2.ZERO, 0, 10, 0.25).wallDistance(Math.toRadians(9)), EXACT);
    }

    @Test
    void aWallWhoseFootLiesOutsideIsReadOnTheConesEdge() {
        assertEquals(0.5, view(Vector2.ZERO, 0, 10, 1).wallDistance(Math.toRadians(70)), EXACT);
        assertEquals(0.5, view(Vector2.ZERO, 0, 10, 1).wallDistance(Math.toRadians(-70)), EXACT);
    }

    @Test
    void aMountCountsByHowFarItLiesTowardsTheWall() {
        assertEquals(1.1, view(new Vector2(0.2, 7), 0, 89, 1).wallDistance(0) - 0.1, EXACT);
        assertEquals(8, view(new Vector2(0.2, 7), QUARTER_TURN, 89, 1).wallDistance(QUARTER_TURN), EXACT);
    }

    @Test
    void whereNothingIsSeenAWallIsBeyondTheRange() {
        SensorView blank = view(Vector2.ZERO, 0, 10, Reading.NOTHING);
        assertFalse(blank.detects());
        assertEquals(0.8, blank.minDistance());
        assertEquals(0.8, blank.perpendicularDistance(), EXACT);
        assertFalse(blank.detectsWithin(100), "that something might be there is not to see it");
    }

    @Test
    void itDetectsWithinTheSumOfMountAndReading() {
        SensorView eye = view(new Vector2(0.5, 0), 0, 10, 0.25);
        assertTrue(eye.detectsWithin(0.75));
        assertFalse(eye.detectsWithin(0.74));
    }

    @Test
    void anAbsentSensorDetectsNothingAtAnyDistance() {
        assertFalse(SensorView.NONE.detects());
        assertFalse(SensorView.NONE.present());
        assertFalse(SensorView.NONE.detectsWithin(100));
    }

    @Test
    void anotherReadingChangesNothingElse() {
        SensorView view = view(new Vector2(0, 0.1), QUARTER_TURN, 10, 0.25);
        assertEquals(view(new Vector2(0, 0.1), QUARTER_TURN, 10, 0.5), view.withReading(0.5));
    }
}
