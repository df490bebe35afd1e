package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.PdGains;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PdControllerTest {

    private static final double DT = 0.001;

    @Test
    void parallelAtTheWantedDistanceItGoesStraight() {
        assertEquals(0, new PdController(0.3, PdGains.forSpeed(0.3, 0.05)).turnRate(0, 0));
    }

    @Test
    void tooFarItTurnsToTheWallAndTooNearAwayFromIt() {
        PdController law = new PdController(0.3, PdGains.forSpeed(0.3, 0.05));
        assertTrue(law.turnRate(0.01, 0) > 0);
        assertEquals(-law.turnRate(0.01, 0), law.turnRate(-0.01, 0), 1e-12);
    }

    @Test
    void headingForTheWallItTurnsAway() {
        assertTrue(new PdController(0.3, PdGains.forSpeed(0.3, 0.05)).turnRate(0, 0.1) < 0);
    }

    @Test
    void theTurnRateIsThePTermAndTheDTerm() {
        PdController law = new PdController(0.3, PdGains.forSpeed(0.3, 0.05));
        double rate = law.turnRate(0.02, 0.1);
        assertEquals(rate, law.proportional() + law.derivative(), 1e-12);
        assertTrue(law.proportional() > 0 && law.derivative() < 0);
    }

    /**
     * Drives an ideal robot for 2 m beside a wall and returns the least error, the last error and the steepest heading.
     */
    private static double[] drive(double speed, double lag, double error) {
        PdController law = new PdController(speed, PdGains.forSpeed(speed, lag));
        double[] seen = {error, error, 0};
        double heading = 0;
        for (double way = 0; way < 2; way += speed * DT) {
            heading += law.turnRate(seen[1], heading) * DT;
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
