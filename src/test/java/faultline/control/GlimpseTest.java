package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vec;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

/**
 * A sensor in the robot's middle that looks ahead, with a cone of twice the angle whose sine is 0.6: a thing at its edge is 4 parts ahead
 * and 3 aside.
 */
class GlimpseTest {

    private final Glimpse glimpse = new Glimpse();

    private static Eye eye(double bearing, double reading) {
        return new Eye(Vec.ZERO, bearing, Math.asin(0.6), 0.8, reading, true);
    }

    private void see(double reading, double rolled) {
        glimpse.update(eye(0, reading), rolled);
    }

    private void lose(double rolled) {
        see(Reading.NOTHING, rolled);
    }

    private double distance() {
        return glimpse.distanceAfter(0);
    }

    @Test
    void atFirstNothingIsKnown() {
        lose(0.1);
        assertEquals(Reading.NOTHING, distance());
    }

    @Test
    void whatIsInSightIsAsFarAsItIsRead() {
        see(0.5, 0);
        assertEquals(0.5, distance(), 1e-12);
        see(0.4, 0.1);
        assertEquals(0.4, distance(), 1e-12);
    }

    @Test
    void whatIsLostWasAtTheEdgeOfTheCone() {
        see(0.5, 0);
        lose(0.4);
        assertEquals(0.3, distance(), 1e-12, "it is abeam");
    }

    @Test
    void theWayThatIsStillToBeRolledCounts() {
        see(0.5, 0);
        assertEquals(Math.hypot(0.3, 0.3), glimpse.distanceAfter(0.1), 1e-12);
    }

    @Test
    void whatIsSeenBehindALostThingDoesNotHideIt() {
        see(0.5, 0);
        see(0.6, 0.2);
        assertEquals(Math.hypot(0.2, 0.3), distance(), 1e-12);
    }

    @Test
    void whatIsBehindTheSensorIsForgotten() {
        see(0.5, 0);
        lose(0.41);
        assertEquals(Reading.NOTHING, distance());
    }

    @Test
    void whatIsForgottenIsGone() {
        see(0.5, 0);
        glimpse.forget();
        assertEquals(Reading.NOTHING, distance());
    }

    @Test
    void aConeThatLooksAsideLosesThingsAtItsRearEdge() {
        for (double side : new double[] {-1, 1}) {
            Glimpse aside = new Glimpse();
            aside.update(eye(side * (Math.PI / 2 - 2 * Math.asin(0.6)), 0.5), 0);
            aside.update(Eye.NONE, 0.3);
            assertEquals(0.4, aside.distanceAfter(0), 1e-12, "at 0.3 m ahead and 0.4 m aside when it was lost");
        }
    }

    @Test
    void itIsMeasuredFromTheRobotsCentre() {
        glimpse.update(new Eye(new Vec(0.1, 0), 0, Math.asin(0.6), 0.8, 0.5, true), 0);
        assertEquals(Math.hypot(0.5, 0.3), distance(), 1e-12);
    }
}
