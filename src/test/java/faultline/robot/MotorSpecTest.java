package faultline.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The motor against its differential equation, tau dv/dt = k u - v. */
class MotorSpecTest {

    @Test
    void aTickIsTheSolutionOfTheDifferentialEquation() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 200; i++) {
            MotorSpec motor =
                    new MotorSpec(random.nextDouble(0.01, 0.5), random.nextDouble(0.01, 1), random.nextDouble(1, 20));
            double speed = random.nextDouble(-2, 2);
            double volts = random.nextDouble(-25, 25);
            double dt = random.nextDouble(0, 0.1);
            assertEquals(integrated(motor, speed, volts, dt), motor.step(speed, volts, motor.decay(dt)), 1e-9);
        }
    }

    @Test
    void afterOneTimeConstantSixtyThreePerCentAreReached() {
        MotorSpec motor = new MotorSpec(0.05, 0.1, 6);
        assertEquals(0.3 * (1 - 1 / Math.E), motor.step(0, 3, motor.decay(0.05)), 1e-15);
    }

    @Test
    void aMotorWithoutTimeConstantFollowsAtOnce() {
        MotorSpec motor = new MotorSpec(0, 0.1, 6);
        assertEquals(0.2, motor.step(-0.5, 2, motor.decay(0.01)), 1e-16);
    }

    @Test
    void theSupplyLimitsTheSpeedBothWays() {
        MotorSpec motor = new MotorSpec(0, 0.1, 6);
        assertEquals(0.6, motor.step(0, 1000, 0), 1e-15);
        assertEquals(-0.6, motor.step(0, -1000, 0), 1e-15);
        assertEquals(0.6, motor.maxSpeed(), 1e-15);
    }

    @Test
    void theVoltageForASpeedHoldsIt() {
        MotorSpec motor = MotorSpec.DEFAULT;
        assertEquals(0.3, motor.step(0.3, motor.voltageFor(0.3), motor.decay(0.01)), 1e-15);
    }

    @ParameterizedTest
    @CsvSource({"-0.1, 0.1, 6", "NaN, 0.1, 6", "0.05, 0, 6", "0.05, Infinity, 6", "0.05, 0.1, 0", "0.05, 0.1, NaN"})
    void anInvalidMotorIsRejected(double timeConstant, double speedConstant, double maxVoltage) {
        assertThrows(IllegalArgumentException.class, () -> new MotorSpec(timeConstant, speedConstant, maxVoltage));
    }

    /** Classic Runge-Kutta with tiny steps. */
    private static double integrated(MotorSpec motor, double from, double volts, double dt) {
        double target = motor.speedConstant() * Math.min(motor.maxVoltage(), Math.max(-motor.maxVoltage(), volts));
        int steps = 2000;
        double h = dt / steps;
        double v = from;
        for (int i = 0; i < steps; i++) {
            double k1 = (target - v) / motor.timeConstant();
            double k2 = (target - (v + h / 2 * k1)) / motor.timeConstant();
            double k3 = (target - (v + h / 2 * k2)) / motor.timeConstant();
            double k4 = (target - (v + h * k3)) / motor.timeConstant();
            v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        return v;
    }
}
