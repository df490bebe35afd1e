package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PdGainsTest {

    private static final double DT = 0.001;

    @Test
    void withoutAnErrorThereIsNothingToCorrect() {
        PdGains gains = PdGains.forSpeed(0.3, 0.05);
        assertEquals(0, gains.proportionalTerm(0));
        assertEquals(0, gains.derivativeTerm(0));
    }

    @Test
    void bothTermsAreOddInTheirError() {
        PdGains gains = PdGains.forSpeed(0.3, 0.05);
        assertTrue(gains.proportionalTerm(0.01) > 0);
        assertEquals(-gains.proportionalTerm(0.01), gains.proportionalTerm(-0.01), 1e-12);
        assertTrue(gains.derivativeTerm(-0.03) < 0, "on the way to the wall it turns away");
        assertEquals(-gains.derivativeTerm(0.03), gains.derivativeTerm(-0.03), 1e-12);
    }

    /**
     * Drives an ideal robot for 2 m beside a wall and returns the least error, the last error and the steepest heading.
     */
    private static double[] drive(double speed, double lag, double error) {
        PdGains gains = PdGains.forSpeed(speed, lag);
        double[] seen = {error, error, 0};
        double heading = 0;
        for (double way = 0; way < 2; way += speed * DT) {
            double rate = -speed * Math.sin(heading);
            heading += (gains.proportionalTerm(seen[1]) + gains.derivativeTerm(rate)) * DT;
            seen[1] -= speed * Math.sin(heading) * DT;
            seen[0] = Math.min(seen[0], seen[1]);
            seen[2] = Math.max(seen[2], heading);
        }
        return seen;
    }

    @ParameterizedTest
    @CsvSource({"0.1, 0.05", "0.3, 0", "0.3, 0.05", "0.3, 0.2", "1, 0.06"})
    void anErrorDiesOutWithoutOvershoot(double speed, double lag) {
        double[] seen = drive(speed, lag, 0.01);
        assertTrue(seen[0] > -0.0005, "it comes nearer than wanted by " + -seen[0]);
        assertEquals(0, seen[1], 0.0005);
    }

    @Test
    void evenFarAwayItNeverHeadsForTheWallSteeperThan30Degrees() {
        assertEquals(30, Math.toDegrees(drive(0.3, 0.05, 5)[2]), 0.5);
    }
}
