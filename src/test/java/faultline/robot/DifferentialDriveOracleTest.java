package faultline.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Pose;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Eqs. (2) and (3) against a Runge-Kutta integration that knows nothing of arcs. */
class DifferentialDriveOracleTest {

    private static final int CASES = 300;
    private static final int STEPS = 400;

    @Test
    void anArcIsTheIntegralOfEquationThree() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < CASES; i++) {
            Pose from = new Pose(random.nextDouble(-5, 5), random.nextDouble(-5, 5), random.nextDouble(-7, 7));
            double v = random.nextDouble(-2, 2);
            double omega = random.nextDouble(-4, 4);
            double dt = random.nextDouble(0, 1);
            assertNear(rungeKutta(from, v, omega, dt), advance(from, v, omega, dt), 1e-9);
        }
    }

    @Test
    void theTaylorLimitJoinsTheClosedFormWithoutAStep() {
        Pose from = new Pose(1, 2, 0.3);
        for (double omega = 1e-14; omega < 1e-2; omega *= 1.1) {
            assertNear(rungeKutta(from, 1, omega, 1), advance(from, 1, omega, 1), 1e-13);
            assertNear(rungeKutta(from, 1, -omega, 1), advance(from, 1, -omega, 1), 1e-13);
        }
    }

    @Test
    void equalAndOppositeWheelsTurnOnTheSpot() {
        Velocity velocity = new WheelSpeeds(-0.3, 0.3).toVelocity(0.2);
        assertNear(new Pose(1, 2, 0.5 + 3), DifferentialDrive.advance(new Pose(1, 2, 0.5), velocity, 1), 1e-15);
    }

    @Test
    void equalWheelsDriveStraight() {
        assertEquals(new Pose(0.5, 0, 0), advance(Pose.ORIGIN, 0.5, 0, 1));
    }

    @Test
    void theSlowerSideIsTheInsideOfTheTurn() {
        double track = 0.2;
        Velocity velocity = new WheelSpeeds(0.1, 0.3).toVelocity(track);
        // Radius v / omega = 0.2: the left wheels run on a circle of 0.1, the right ones of 0.3, three times as fast.
        assertEquals(0.2, velocity.linear() / velocity.angular(), 1e-15);
        Pose half = DifferentialDrive.advance(Pose.ORIGIN, velocity, Math.PI / velocity.angular());
        assertNear(new Pose(0, 0.4, Math.PI), half, 1e-15);
    }

    @Test
    void manyShortArcsMakeOneLongArc() {
        Pose whole = advance(Pose.ORIGIN, 0.3, 0.7, 2);
        Pose pieces = Pose.ORIGIN;
        for (int i = 0; i < 2000; i++) {
            pieces = advance(pieces, 0.3, 0.7, 0.001);
        }
        assertNear(whole, pieces, 1e-12);
    }

    @Test
    void theWheelSpeedsForAVelocityGiveThatVelocity() {
        WheelSpeeds speeds = WheelSpeeds.of(new Velocity(0.3, 2), 0.2);
        assertEquals(new WheelSpeeds(0.3 - 0.2, 0.3 + 0.2), speeds);
        assertEquals(new Velocity(0.3, 2), speeds.toVelocity(0.2));
    }

    private static Pose advance(Pose from, double v, double omega, double dt) {
        return DifferentialDrive.advance(from, new Velocity(v, omega), dt);
    }

    private static Pose rungeKutta(Pose from, double v, double omega, double dt) {
        double h = dt / STEPS;
        double x = from.x();
        double y = from.y();
        double theta = from.heading();
        for (int i = 0; i < STEPS; i++) {
            // theta' is constant, so that k2 = k3: the classic rule is Simpson's.
            double middle = theta + omega * h / 2;
            double end = theta + omega * h;
            x += h / 6 * v * (Math.cos(theta) + 4 * Math.cos(middle) + Math.cos(end));
            y += h / 6 * v * (Math.sin(theta) + 4 * Math.sin(middle) + Math.sin(end));
            theta = end;
        }
        return new Pose(x, y, theta);
    }

    private static void assertNear(Pose expected, Pose actual, double tolerance) {
        assertEquals(expected.x(), actual.x(), tolerance, () -> expected + " " + actual);
        assertEquals(expected.y(), actual.y(), tolerance, () -> expected + " " + actual);
        assertEquals(expected.heading(), actual.heading(), tolerance, () -> expected + " " + actual);
    }
}
