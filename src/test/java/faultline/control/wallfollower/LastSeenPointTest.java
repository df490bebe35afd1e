package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

/**
 * A sensor in the robot's middle that looks ahead, with a cone of twice the angle whose sine is 0.6: a thing at its
 * edge is 4 parts ahead and 3 aside.
 */
class LastSeenPointTest {

    private final LastSeenPoint lastSeen = new LastSeenPoint();

    private static SensorView view(double bearing, double reading) {
        return new SensorView(Vector2.ZERO, bearing, Math.asin(0.6), 0.8, reading, true);
    }

    private void detect(double reading, double rolled) {
        lastSeen.update(view(0, reading), rolled);
    }

    private void loseTarget(double rolled) {
        detect(Reading.NOTHING, rolled);
    }

    private double distance() {
        return lastSeen.distanceAfter(0);
    }

    @Test
    void atFirstNothingIsKnown() {
        loseTarget(0.1);
        assertEquals(Reading.NOTHING, distance());
    }

    @Test
    void whatIsInSightIsAsFarAsItIsRead() {
        detect(0.5, 0);
        assertEquals(0.5, distance(), 1e-12);
        detect(0.4, 0.1);
        assertEquals(0.4, distance(), 1e-12);
    }

    @Test
    void whatIsLostWasAtTheEdgeOfTheCone() {
        detect(0.5, 0);
        loseTarget(0.4);
        assertEquals(0.3, distance(), 1e-12, "it is abeam");
    }

    @Test
    void theWayThatIsStillToBeRolledCounts() {
        detect(0.5, 0);
        assertEquals(Math.hypot(0.3, 0.3), lastSeen.distanceAfter(0.1), 1e-12);
    }

    @Test
    void whatIsSeenBehindALostTargetDoesNotHideIt() {
        detect(0.5, 0);
        detect(0.6, 0.2);
        assertEquals(Math.hypot(0.2, 0.3), distance(), 1e-12);
    }

    @Test
    void whatIsBehindTheSensorIsForgotten() {
        detect(0.5, 0);
        loseTarget(0.41);
        assertEquals(Reading.NOTHING, distance());
    }

    @Test
    void whatIsForgottenIsGone() {
        detect(0.5, 0);
        lastSeen.clear();
        assertEquals(Reading.NOTHING, distance());
    }

    @Test
    void aConeThatLooksAsideLosesTargetsAtItsRearEdge() {
        for (double side : new double[] {-1, 1}) {
            LastSeenPoint aside = new LastSeenPoint();
            aside.update(view(side * (Math.PI / 2 - 2 * Math.asin(0.6)), 0.5), 0);
            aside.update(SensorView.NONE, 0.3);
            assertEquals(0.4, aside.distanceAfter(0), 1e-12, "at 0.3 m ahead and 0.4 m aside when it was lost");
        }
    }

    @Test
    void itIsMeasuredFromTheRobotsCentre() {
        lastSeen.update(new SensorView(new Vector2(0.1, 0), 0, Math.asin(0.6), 0.8, 0.5, true), 0);
        assertEquals(Math.hypot(0.5, 0.3), distance(), 1e-12);
    }
}
