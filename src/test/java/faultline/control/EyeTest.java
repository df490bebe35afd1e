package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vec;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

class EyeTest {

    private static final double EXACT = 1e-12;
    private static final double QUARTER = Math.PI / 2;

    private static Eye eye(Vec seat, double bearing, double halfConeDegrees, double reading) {
        return new Eye(seat, bearing, Math.toRadians(halfConeDegrees), 0.8, reading, true);
    }

    @Test
    void aWallAcrossTheAxisIsAsFarFromTheCentreAsSeatAndReadingTogether() {
        assertEquals(0.35, eye(new Vec(0, 0.1), QUARTER, 10, 0.25).squareDistance(), EXACT);
    }

    @Test
    void aWallWhoseFootLiesInTheConeIsAsFarAsTheReading() {
        assertEquals(0.25, eye(Vec.ZERO, 0, 10, 0.25).wallDistance(Math.toRadians(9)), EXACT);
    }

    @Test
    void aWallWhoseFootLiesOutsideIsReadOnTheConesEdge() {
        assertEquals(0.5, eye(Vec.ZERO, 0, 10, 1).wallDistance(Math.toRadians(70)), EXACT);
        assertEquals(0.5, eye(Vec.ZERO, 0, 10, 1).wallDistance(Math.toRadians(-70)), EXACT);
    }

    @Test
    void aSeatCountsByHowFarItLiesTowardsTheWall() {
        assertEquals(1.1, eye(new Vec(0.2, 7), 0, 89, 1).wallDistance(0) - 0.1, EXACT);
        assertEquals(8, eye(new Vec(0.2, 7), QUARTER, 89, 1).wallDistance(QUARTER), EXACT);
    }

    @Test
    void whereNothingIsSeenAWallIsBeyondTheRange() {
        Eye blank = eye(Vec.ZERO, 0, 10, Reading.NOTHING);
        assertFalse(blank.sees());
        assertEquals(0.8, blank.atLeast());
        assertEquals(0.8, blank.squareDistance(), EXACT);
        assertFalse(blank.seesWithin(100), "that something might be there is not to see it");
    }

    @Test
    void itSeesWithinWhatSeatAndReadingReach() {
        Eye eye = eye(new Vec(0.5, 0), 0, 10, 0.25);
        assertTrue(eye.seesWithin(0.75));
        assertFalse(eye.seesWithin(0.74));
    }

    @Test
    void anEyeThatIsNotThereSeesNothingAtAnyDistance() {
        assertFalse(Eye.NONE.sees());
        assertFalse(Eye.NONE.present());
        assertFalse(Eye.NONE.seesWithin(100));
    }
}
