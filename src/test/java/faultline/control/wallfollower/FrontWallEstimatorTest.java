package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Walls ahead as seen by eyes at the robot's centre with all but no cone, so that a reading is the distance of the wall
 * over the cosine of its slant.
 */
class FrontWallEstimatorTest {

    private static final double DIAGONAL = Math.PI / 4;
    private static final double MAX_SLANT = Math.toRadians(70);

    private static SensorView view(double bearing, double reading) {
        return new SensorView(Vector2.ZERO, bearing, 0, 2.1, reading, true);
    }

    /** Sees a wall one metre off the centre, whose foot is at a bearing. */
    private static FrontWallEstimator wallAt(double foot) {
        return new FrontWallEstimator(viewOfWall(0, foot), viewOfWall(DIAGONAL, foot), viewOfWall(-DIAGONAL, foot));
    }

    private static SensorView viewOfWall(double bearing, double foot) {
        double reading = 1 / Math.cos(foot - bearing);
        return view(bearing, reading > 0 && reading <= 2.1 ? reading : Reading.NOTHING);
    }

    /** The least distance, to a tenth of a millimetre, that the wall will be within. */
    private static double distanceAfter(
            double rolled, FrontWallEstimator estimator, double mostLeft, double mostRight) {
        double least = 0;
        while (least < 3 && !estimator.isWithin(least, rolled, mostLeft, mostRight)) {
            least += 0.0001;
        }
        return least;
    }

    @ParameterizedTest
    @ValueSource(doubles = {-55, -40, -20, 0, 20, 40, 55})
    void aWallOfAnySlantIsAsFarAsItIs(double degrees) {
        assertEquals(1, distanceAfter(0, wallAt(Math.toRadians(degrees)), MAX_SLANT, MAX_SLANT), 0.002);
    }

    @Test
    void rollingOnBringsASquareWallNearerByTheWay() {
        assertEquals(0.9, distanceAfter(0.1, wallAt(0), MAX_SLANT, MAX_SLANT), 0.002);
    }

    @Test
    void rollingOnBringsASlantedWallNearerByLess() {
        assertEquals(
                0.9,
                distanceAfter(0.2, wallAt(Math.toRadians(-60)), Math.toRadians(60), Math.toRadians(60)),
                0.002,
                "cos 60 degrees is a half");
    }

    @Test
    void withoutFurtherReadingsTheWallIsTakenAsSquare() {
        FrontWallEstimator frontOnly = new FrontWallEstimator(view(0, 1.5), SensorView.NONE, SensorView.NONE);
        assertEquals(1.5, distanceAfter(0, frontOnly, MAX_SLANT, MAX_SLANT), 0.002);
    }

    @Test
    void aSlantBeyondWhatIsPossibleIsNotAssumed() {
        double limit = Math.toRadians(20);
        assertTrue(
                distanceAfter(0, wallAt(Math.toRadians(55)), limit, limit) > 1.5,
                "a reading of 1.74 m, times the cosine of 20 degrees");
    }

    @Test
    void whereTheFrontSensorSeesNothingNothingIsAhead() {
        FrontWallEstimator aside =
                new FrontWallEstimator(view(0, Reading.NOTHING), view(DIAGONAL, 0.1), view(-DIAGONAL, 0.1));
        assertFalse(aside.isWithin(100, 0, MAX_SLANT, MAX_SLANT));
    }
}
