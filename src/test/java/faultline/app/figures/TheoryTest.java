package faultline.app.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Timing;
import faultline.geometry.Degrees;
import faultline.geometry.Vec;
import org.junit.jupiter.api.Test;

/** The edges that are found by walking the exact cone are those that the formula gives for an endless wall. */
class TheoryTest {

    @Test
    void theEdgeSolvesTheFormulaOfTheDesign() {
        for (double distance = 0.2; distance < 0.85; distance += 0.05) {
            Theory theory = Theory.of(Alignment.usual(Timing.RANGE, 0), new Vec(Alignment.WALL, Alignment.WALL - distance));
            double phi0 = theory.edge(0.8, 1);
            // R cos(max(0, phi0 - b)) + a cos(phi0) = D
            double reach = 0.8 * Math.cos(Math.max(0, phi0 - Degrees.toRadians(10))) + 0.1 * Math.cos(phi0);
            assertEquals(distance, reach, 1e-9);
            assertEquals(-phi0, theory.edge(0.8, -1), 1e-9);
        }
    }

    @Test
    void toTheLetterTheLagOfTheMotorsAndHalfAPeriodAreLost() {
        Theory theory = Theory.of(Alignment.usual(Timing.RANGE, 0), new Vec(Alignment.WALL, Alignment.WALL - 0.35));
        assertEquals(-60 * (0.05 + 0.01 / 2), Math.toDegrees(theory.error()), 1e-6);
    }

    @Test
    void equalReadingsLoseNothing() {
        Theory theory = Theory.of(Alignment.usual(Timing.EQUAL_READINGS, 0), new Vec(Alignment.WALL, Alignment.WALL - 0.35));
        assertEquals(0, theory.error(), 1e-9);
    }
}
