package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * The range rule, our reading of eq. (4), is exact for a perfect robot beside an endless wall; and the bias of each
 * thing that is not perfect.
 */
class AlignmentModelTest {

    private static final double RATE = Math.toRadians(60);
    private static final double RANGE = 0.8;
    private static final double CONE = Math.toRadians(20);
    private static final double DISTANCE = 0.4;
    /** Two looks at the perfect robot's period. */
    private static final double EXACT = 2e-4 * RATE;

    private static final AlignmentModel IDEAL = AlignmentModel.ideal(DISTANCE, RATE, RANGE, CONE);

    @Test
    void theRuleIsExactForAnyDistanceRangeConeAndRate() {
        SplittableRandom random = new SplittableRandom(71);
        for (int i = 0; i < 250; i++) {
            double range = random.nextDouble(0.3, 2);
            double distance = random.nextDouble(0.2, 0.1 + 0.95 * range);
            double rate = Math.toRadians(random.nextDouble(20, 180));
            AlignmentModel turn = AlignmentModel.ideal(distance, rate, range, Math.toRadians(random.nextDouble(1, 60)));
            assertEquals(0, turn.headingError(), 2e-4 * rate, turn::toString);
        }
    }

    /** phi0, the edge of the detection interval, solves R cos(max(0, phi0 - b)) + a cos(phi0) = D. */
    @Test
    void sparseSamplingDetectsEachEdgeLate() {
        double period = 0.05;
        double sum = 0;
        int phases = 50;
        for (int i = 0; i < phases; i++) {
            double error = IDEAL.withSampling(period, i * period / phases).headingError();
            assertTrue(
                    error <= EXACT && error >= -RATE * period - EXACT,
                    "up to omega T too far to the right, not " + error);
            sum += error;
        }
        // Each edge is seen between 0 and T late; over all phases of one edge alone the mean need not be T/2, so a
        // quarter of it is
        // granted.
        assertEquals(-RATE * period / 2, sum / phases, RATE * period / 4);
    }

    @Test
    void overManyDistancesTheMeanDelayIsHalfAPeriod() {
        double period = 0.05;
        SplittableRandom random = new SplittableRandom(72);
        double sum = 0;
        int cases = 400;
        for (int i = 0; i < cases; i++) {
            AlignmentModel turn = AlignmentModel.ideal(random.nextDouble(0.2, 0.8), RATE, RANGE, CONE);
            sum += turn.withSampling(period, random.nextDouble(period)).headingError();
        }
        // Four standard errors of the mean of two even delays: omega T / sqrt(24 n).
        assertEquals(-RATE * period / 2, sum / cases, 4 * RATE * period / Math.sqrt(24.0 * cases) + EXACT);
    }

    @Test
    void aLaggingMotorLosesOmegaTauAndTurningBackTauLongerMakesUpForIt() {
        for (double tau : new double[] {0.02, 0.05, 0.2}) {
            assertEquals(-RATE * tau, IDEAL.withLag(tau).headingError(), EXACT);
            assertEquals(0, IDEAL.withLag(tau).headingError(tau), EXACT);
        }
    }

    @Test
    void anAxisThatMissesTheCentreShiftsBothEdgesAlike() {
        double a = 0.1;
        double b = CONE / 2;
        double ahead = 0.02;
        double phi0 = edge(a, b);
        // Mounted s ahead, the apex rises by s sin(theta): to first order each edge moves by s sin(phi0) / (R sin(phi0
        // -
        // b) + a sin(phi0)).
        double shift = ahead * Math.sin(phi0) / (RANGE * Math.sin(phi0 - b) + a * Math.sin(phi0));
        assertEquals(shift, IDEAL.withMountPosition(new Vector2(ahead, a)).headingError(), 0.02 * shift);
        assertEquals(-shift, IDEAL.withMountPosition(new Vector2(-ahead, a)).headingError(), 0.02 * shift);
        assertEquals(0, IDEAL.withMountPosition(new Vector2(0, 0.05)).headingError(), EXACT);
    }

    private static double edge(double a, double b) {
        double low = 0;
        double high = Math.PI / 2;
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            boolean seen = RANGE * Math.cos(Math.max(0, middle - b)) + a * Math.cos(middle) >= DISTANCE;
            low = seen ? middle : low;
            high = seen ? high : middle;
        }
        return low;
    }

    @Test
    void aWallShorterThanTheSweptConePullsTowardsWhatThereIsOfIt() {
        List<ConvexShape> endsAhead = List.of(new Segment(-50, DISTANCE, 0.2, DISTANCE));
        List<ConvexShape> endsBehind = List.of(new Segment(-0.2, DISTANCE, 50, DISTANCE));
        double error = IDEAL.withWalls(endsAhead).headingError();
        assertTrue(error > Math.toRadians(5), "turned towards the longer end behind, to the left: " + error);
        assertEquals(-error, IDEAL.withWalls(endsBehind).headingError(), 2 * EXACT);
        // Once both ends lie beyond range and mounting position, the wall is effectively endless.
        assertEquals(
                0,
                IDEAL.withWalls(List.of(new Segment(-0.9, DISTANCE, 0.9, DISTANCE)))
                        .headingError(),
                EXACT);
    }

    @Test
    void inASquareCornerTheWallsMergeUnlessTheTimingLevelIsCloseToTheWall() {
        // Wall A on the left is the one to be parallel to; wall B behind, which the left sensor sees first as the robot
        // spins right.
        List<ConvexShape> corner =
                List.of(new Segment(-0.5, DISTANCE, 50, DISTANCE), new Segment(-0.5, DISTANCE, -0.5, -50));
        AlignmentModel merged = IDEAL.withWalls(corner);
        assertTrue(
                merged.headingError() > Math.toRadians(20), "half way between the two walls: " + merged.headingError());
        double nearest = DISTANCE - 0.1;
        assertEquals(0, merged.withTimingLevel(1.2 * nearest).headingError(), EXACT);
    }
}
