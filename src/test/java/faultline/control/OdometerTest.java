package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.List;
import org.junit.jupiter.api.Test;

class OdometerTest {

    private static final double EXACT = 1e-12;
    private static final double DT = 0.01;
    private static final RobotSpec LAG_FREE = robot(0);
    private static final RobotSpec LAGGING = robot(0.1);

    private final Odometer odometer = new Odometer();

    private static RobotSpec robot(double timeConstant) {
        return new RobotSpec(0.25, 0.2, 0.18, 0.3, 1, new MotorSpec(timeConstant, 0.1, 6), DriveScale.NONE, List.of());
    }

    private void drive(RobotSpec robot, Velocity velocity, double dt, long ticks) {
        WheelSpeeds wheels = WheelSpeeds.of(velocity, robot.track());
        odometer.advance(
                robot, robot.motor().voltageFor(wheels.left()), robot.motor().voltageFor(wheels.right()), dt, ticks);
    }

    @Test
    void aSecondAt30CentimetresPerSecondIs30Centimetres() {
        drive(LAG_FREE, new Velocity(0.3, 0), DT, 100);
        assertEquals(0.3, odometer.deltaDistance(), EXACT);
        assertEquals(0, odometer.deltaHeading());
    }

    @Test
    void headingAddsUpAndTheLastTurnDoesNot() {
        drive(LAG_FREE, new Velocity(0, 2), DT, 50);
        drive(LAG_FREE, new Velocity(0, -0.5), DT, 100);
        assertEquals(-0.5, odometer.deltaHeading(), EXACT);
        assertEquals(0.5, odometer.heading(), EXACT);
        assertEquals(-0.5, odometer.omega(), EXACT);
    }

    @Test
    void wheelsGoNoFasterThanTheSupplyAllows() {
        drive(LAG_FREE, new Velocity(5, 0), DT, 100);
        assertEquals(0.6, odometer.deltaDistance(), EXACT);
    }

    @Test
    void beforeAnyTickNothingHasMoved() {
        drive(LAGGING, new Velocity(0.3, 1), DT, 0);
        assertEquals(0, odometer.deltaDistance());
        assertEquals(0, odometer.heading());
    }

    @Test
    void motorsWithoutLagHaveNone() {
        drive(LAG_FREE, Velocity.ZERO, DT, 1);
        assertEquals(0, odometer.motorLag());
    }

    @Test
    void forShortTicksTheLagIsTheTimeConstant() {
        drive(LAGGING, Velocity.ZERO, 1e-6, 1);
        assertEquals(0.1, odometer.motorLag(), 1e-6);
    }

    @Test
    void theLagIsThatOfTheLatestMotorsAndTick() {
        drive(LAGGING, Velocity.ZERO, DT, 1);
        drive(LAGGING, Velocity.ZERO, 1e-6, 1);
        assertEquals(0.1, odometer.motorLag(), 1e-6);
        drive(LAG_FREE, Velocity.ZERO, 1e-6, 1);
        assertEquals(0, odometer.motorLag());
    }

    @Test
    void aSpinNoLongerCommandedGoesOnForTheLag() {
        drive(LAGGING, new Velocity(0, 1), DT, 1000);
        assertEquals(1, odometer.omega(), 1e-9);
        drive(LAGGING, new Velocity(0, 0), DT, 1000);
        assertEquals(odometer.motorLag(), odometer.deltaHeading(), 1e-9);
        assertTrue(odometer.deltaHeading() > 0.09, "about 1 rad/s for 0.1 s");
    }

    @Test
    void wheelsThatTurnAtTheStartContinue() {
        odometer.setWheels(new WheelSpeeds(0.1, 0.3));
        assertEquals(new WheelSpeeds(0.1, 0.3), odometer.wheels());
        drive(LAGGING, Velocity.ZERO, DT, 1000);
        assertEquals(0.2 * odometer.motorLag(), odometer.deltaDistance(), 1e-9);
    }
}
