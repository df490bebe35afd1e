package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DeadReckoningTest {

    private static final double DT = 0.01;
    /** A robot whose wheels reach their speed at once: 0.1 m/s for a volt. */
    private static final RobotSpec PROMPT = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));

    private final DeadReckoning reckoning = new DeadReckoning();

    @ParameterizedTest
    @CsvSource({"3, 3", "2, 3", "3, 2", "-1, 1", "-2, -3", "6, -6", "0, 0", "2.9, 3"})
    void constantVoltagesDriveAnArc(double left, double right) {
        double v = 0.1 * (left + right) / 2;
        double omega = 0.1 * (right - left) / PROMPT.track();
        for (int i = 1; i <= 200; i++) {
            reckoning.advance(PROMPT, left, right, DT, 1);
            double turn = omega * DT * i;
            double x = omega == 0 ? v * DT * i : v / omega * Math.sin(turn);
            double y = omega == 0 ? 0 : v / omega * (1 - Math.cos(turn));
            assertEquals(turn, reckoning.heading(), 1e-9);
            assertEquals(Math.cos(turn), reckoning.headingCos(), 1e-9);
            assertEquals(Math.sin(turn), reckoning.headingSin(), 1e-9);
            assertEquals(x, reckoning.x(), 2e-5);
            assertEquals(y, reckoning.y(), 2e-5);
        }
        assertEquals(v, reckoning.odometer().v(), 1e-12);
        assertEquals(omega, reckoning.odometer().omega(), 1e-12);
        assertEquals(v * DT, reckoning.rolled(), 1e-12);
        assertEquals(omega * DT, reckoning.turned(), 1e-12);
        assertEquals(Math.abs(v) * 2, reckoning.distance(), 1e-9);
        assertEquals(Math.abs(omega) * 2, reckoning.turning(), 1e-9);
    }

    @Test
    void severalTicksAtOnceAreTheSameAsOneByOne() {
        DeadReckoning single = new DeadReckoning();
        reckoning.advance(RobotSpec.DEFAULT, 2, 3, DT, 7);
        double rolled = 0;
        double turned = 0;
        for (int i = 0; i < 7; i++) {
            single.advance(RobotSpec.DEFAULT, 2, 3, DT, 1);
            rolled += single.rolled();
            turned += single.turned();
        }
        assertEquals(single.x(), reckoning.x());
        assertEquals(single.y(), reckoning.y());
        assertEquals(single.heading(), reckoning.heading());
        assertEquals(rolled, reckoning.rolled(), 1e-15);
        assertEquals(turned, reckoning.turned(), 1e-15);
    }

    @Test
    void wheelsReachTheirSpeedByAnExponential() {
        reckoning.advance(RobotSpec.DEFAULT, 3, 3, DT, 5);
        assertEquals(0.3 * (1 - Math.exp(-1)), reckoning.odometer().v(), 1e-12);
        reckoning.advance(RobotSpec.DEFAULT, 3, 3, 2 * DT, 5);
        assertEquals(0.3 * (1 - Math.exp(-3)), reckoning.odometer().v(), 1e-12, "with another length of a tick");
        reckoning.advance(PROMPT, 3, 3, 2 * DT, 1);
        assertEquals(0.3, reckoning.odometer().v(), 1e-12, "with another motor");
    }

    @Test
    void distancesAndTurnsCountInBothDirections() {
        reckoning.advance(PROMPT, 3, 3, DT, 10);
        reckoning.advance(PROMPT, -3, -3, DT, 10);
        reckoning.advance(PROMPT, -1, 1, DT, 10);
        reckoning.advance(PROMPT, 1, -1, DT, 10);
        assertEquals(0, reckoning.x(), 1e-12);
        assertEquals(0.06, reckoning.distance(), 1e-12);
        assertEquals(0, reckoning.heading(), 1e-12);
        assertEquals(2 * 10 * DT * 0.2 / 0.18, reckoning.turning(), 1e-12);
        assertEquals(-10 * DT * 0.2 / 0.18, reckoning.turned(), 1e-12);
    }

    @Test
    void aCurvatureThatTheMotorsLackTurnsTheRobotAsItRolls() {
        reckoning.setCurvature(0.5);
        reckoning.advance(PROMPT, 3, 3, DT, 100);
        assertEquals(0.15, reckoning.heading(), 1e-12);
        assertEquals(Math.sin(0.15) / 0.5, reckoning.x(), 1e-6);
        assertEquals((1 - Math.cos(0.15)) / 0.5, reckoning.y(), 1e-6);
        reckoning.advance(PROMPT, -3, -3, DT, 100);
        assertEquals(0, reckoning.heading(), 1e-12);
    }
}
