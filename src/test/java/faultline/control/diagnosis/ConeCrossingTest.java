package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConeCrossingTest {

    private final MotionAccumulator motion = new MotionAccumulator();

    private ConeCrossing of(int sensor) {
        return new ConeCrossing(MountedCone.of(RobotSpec.DEFAULT.sensors().get(sensor), WallSide.LEFT), motion);
    }

    private void move(int ticks, double rolled, double turned) {
        for (int i = 0; i < ticks; i++) {
            motion.advance(rolled, turned, 0.01);
        }
    }

    @Test
    void aPoleBesideThePathCrossesTheWholeCone() {
        // At 0.25 m the cone is 8.7 cm wide.
        ConeCrossing crossing = of(2);
        move(1, 0.003, 0);
        crossing.appear(0.25);
        move(10, 0.003, 0);
        assertFalse(crossing.canDisappear(0.25));
        move(20, 0.003, 0);
        assertTrue(crossing.canDisappear(0.25));
    }

    @Test
    void aPoleThatCameInLeavesAtTheSameBorderOnceTheConeSwingsBack() {
        ConeCrossing crossing = of(2);
        move(1, 0.003, 0);
        crossing.appear(0.25);
        move(3, 0.002, 0);
        assertFalse(crossing.canDisappear(0.25));
        move(3, 0.002, 0.01);
        assertTrue(crossing.canDisappear(0.25));
    }

    @Test
    void aConeThatKeepsToACornerMayLoseIt() {
        // Rolling moves the cone forward by 2 mm at the corner, turning back by as much: which way it moves is not
        // sure.
        ConeCrossing crossing = of(2);
        double turned = 1.02
                * 0.002
                / (0.25 + RobotSpec.DEFAULT.sensors().get(2).mountPosition().y());
        move(1, 0.002, turned);
        crossing.appear(0.25);
        move(1, 0.002, turned);
        assertTrue(crossing.canDisappear(0.25));
    }

    @Test
    void nothingComesAndGoesWhileTheRobotStands() {
        ConeCrossing crossing = of(2);
        move(1, 0, 0);
        crossing.appear(0.25);
        move(1, 0, 0);
        assertFalse(crossing.canDisappear(0.25));
    }

    @Test
    void aRobotThatDrivesStraightAheadLosesPolesOnBothSidesButFindsNone() {
        ConeCrossing crossing = of(0);
        move(1, 0.003, 0);
        crossing.appear(0.4);
        move(30, 0.003, 0);
        assertFalse(crossing.canDisappear(0.3));
    }

    @ParameterizedTest
    @CsvSource({
        "2, 0.003, 0",
        "2, -0.003, 0",
        "6, 0.003, 0",
        "6, -0.003, 0",
        "2, 0, 0.003",
        "2, 0, -0.003",
        "0, 0, 0.003"
    })
    void aSurfaceCrossesFourFifthsOfTheConeInEitherDirection(int sensor, double rolled, double turned) {
        double apex = sensor == 0 ? 0.125 : 0.1;
        double step = Math.abs(rolled) + Math.abs(turned) * (0.25 + apex);
        int least = (int) (0.8 * 2 * 0.25 * Math.sin(Math.toRadians(10)) / step);
        ConeCrossing crossing = of(sensor);
        move(1, rolled, turned);
        crossing.appear(0.25);
        move(least, rolled, turned);
        assertFalse(crossing.canDisappear(0.25));
        move(1, rolled, turned);
        assertTrue(crossing.canDisappear(0.25));
    }

    @Test
    void aDiagonalConeIsCrossedMoreSlowlyByRolling() {
        // The left border of front-left lies at 55 degrees: the surface leaves there.
        ConeCrossing crossing = of(1);
        move(1, 0.003, 0);
        crossing.appear(0.25);
        int least = (int) (0.8 * 2 * 0.25 * Math.sin(Math.toRadians(10)) / (0.003 * Math.sqrt(0.5)));
        move(least, 0.003, 0);
        assertFalse(crossing.canDisappear(0.25));
        move(1, 0.003, 0);
        assertTrue(crossing.canDisappear(0.25));
    }
}
