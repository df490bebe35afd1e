package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
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

    @Test
    void aSecondAt30CentimetresPerSecondIs30Centimetres() {
        odometer.setCommand(new Velocity(0.3, 0));
        odometer.advance(LAG_FREE, DT, 100);
        assertEquals(0.3, odometer.deltaDistance(), EXACT);
        assertEquals(0, odometer.deltaHeading());
    }

    @Test
    void headingAddsUpAndTheLastTurnDoesNot() {
        odometer.setCommand(new Velocity(0, 2));
        odometer.advance(LAG_FREE, DT, 50);
        odometer.setCommand(new Velocity(0, -0.5));
        odometer.advance(LAG_FREE, DT, 100);
        assertEquals(-0.5, odometer.deltaHeading(), EXACT);
        assertEquals(0.5, odometer.heading(), EXACT);
        assertEquals(-0.5, odometer.omega(LAG_FREE), EXACT);
    }

    @Test
    void wheelsGoNoFasterThanTheSupplyAllows() {
        odometer.setCommand(new Velocity(5, 0));
        odometer.advance(LAG_FREE, DT, 100);
        assertEquals(0.6, odometer.deltaDistance(), EXACT);
    }

    @Test
    void beforeAnyTickNothingHasMoved() {
        odometer.setCommand(new Velocity(0.3, 1));
        odometer.advance(LAGGING, DT, 0);
        assertEquals(0, odometer.deltaDistance());
        assertEquals(0, odometer.heading());
    }

    @Test
    void motorsWithoutLagHaveNone() {
        odometer.advance(LAG_FREE, DT, 1);
        assertEquals(0, odometer.motorLag());
    }

    @Test
    void forShortTicksTheLagIsTheTimeConstant() {
        odometer.advance(LAGGING, 1e-6, 1);
        assertEquals(0.1, odometer.motorLag(), 1e-6);
    }

    @Test
    void theLagIsThatOfTheLatestMotorsAndTick() {
        odometer.advance(LAGGING, DT, 1);
        odometer.advance(LAGGING, 1e-6, 1);
        assertEquals(0.1, odometer.motorLag(), 1e-6);
        odometer.advance(LAG_FREE, 1e-6, 1);
        assertEquals(0, odometer.motorLag());
    }

    @Test
    void aSpinNoLongerCommandedGoesOnForTheLag() {
        odometer.setCommand(new Velocity(0, 1));
        odometer.advance(LAGGING, DT, 1000);
        assertEquals(1, odometer.omega(LAGGING), 1e-9);
        odometer.setCommand(new Velocity(0, 0));
        odometer.advance(LAGGING, DT, 1000);
        assertEquals(odometer.motorLag(), odometer.deltaHeading(), 1e-9);
        assertTrue(odometer.deltaHeading() > 0.09, "about 1 rad/s for 0.1 s");
    }
}
