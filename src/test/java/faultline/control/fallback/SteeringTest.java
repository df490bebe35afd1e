package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;

class SteeringTest {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;

    @Test
    void straightAheadItDrivesAtFullSpeed() {
        assertEquals(ROBOT.speed(), Steering.speed(ROBOT, 0));
        assertEquals(0, Steering.turnRate(ROBOT, 0));
    }

    @Test
    void itSlowsDownAsTheDirectionIsFartherOffOnEitherSide() {
        double half = Steering.speed(ROBOT, 0.5 * Steering.ASIDE);
        double all = Steering.speed(ROBOT, Steering.ASIDE);
        assertTrue(half < ROBOT.speed() && all < half, half + " " + all);
        assertEquals(0.3 * ROBOT.speed(), all, 1e-12);
        assertEquals(half, Steering.speed(ROBOT, -0.5 * Steering.ASIDE));
    }

    @Test
    void itTurnsTowardTheDirectionAndNoFasterThanTheRobotTurns() {
        assertEquals(0.25, Steering.turnRate(ROBOT, 0.1), 1e-12);
        assertEquals(-0.25, Steering.turnRate(ROBOT, -0.1), 1e-12);
        assertEquals(ROBOT.spinRate(), Steering.turnRate(ROBOT, Steering.ASIDE));
    }

    @Test
    void onTheSpotItTurnsTwiceAsFastIfTheMotorsCan() {
        double fast = Math.min(2 * ROBOT.turnRate(), ROBOT.maxTurnRate());
        assertTrue(fast > ROBOT.spinRate());
        assertEquals(fast, Steering.turnRate(ROBOT, 1.1 * Steering.ASIDE));
        assertEquals(-fast, Steering.turnRate(ROBOT, -3));
    }
}
