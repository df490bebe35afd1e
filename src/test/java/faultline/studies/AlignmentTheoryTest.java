package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.TimingRule;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import org.junit.jupiter.api.Test;

/** The edges that are found by walking the exact cone are those that the formula gives for an endless wall. */
class AlignmentTheoryTest {

    @Test
    void theEdgeSolvesTheFormulaOfTheDesign() {
        for (double distance = 0.2; distance < 0.85; distance += 0.05) {
            AlignmentTheory theory = AlignmentTheory.of(
                    AlignmentTrial.standard(TimingRule.RANGE, 0),
                    new Vector2(AlignmentTrial.WALL_Y, AlignmentTrial.WALL_Y - distance));
            double phi0 = theory.edgeHeading(0.8, 1);
            // R cos(max(0, phi0 - b)) + a cos(phi0) = D
            double reach = 0.8 * Math.cos(Math.max(0, phi0 - Degrees.toRadians(10))) + 0.1 * Math.cos(phi0);
            assertEquals(distance, reach, 1e-9);
            assertEquals(-phi0, theory.edgeHeading(0.8, -1), 1e-9);
        }
    }

    @Test
    void theRangeRuleMissesTheMotorLagAndHalfAPeriod() {
        AlignmentTheory theory = AlignmentTheory.of(
                AlignmentTrial.standard(TimingRule.RANGE, 0),
                new Vector2(AlignmentTrial.WALL_Y, AlignmentTrial.WALL_Y - 0.35));
        assertEquals(-60 * (0.05 + 0.01 / 2), Math.toDegrees(theory.headingError()), 1e-6);
    }

    @Test
    void equalReadingsHaveNoSystematicError() {
        AlignmentTheory theory = AlignmentTheory.of(
                AlignmentTrial.standard(TimingRule.EQUAL_READINGS, 0),
                new Vector2(AlignmentTrial.WALL_Y, AlignmentTrial.WALL_Y - 0.35));
        assertEquals(0, theory.headingError(), 1e-9);
    }
}
