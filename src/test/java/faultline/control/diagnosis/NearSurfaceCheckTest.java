package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NearSurfaceCheckTest {

    private static final double DIAGONAL = Math.toRadians(45);
    private static final MountedCone CONE = new MountedCone(0.125, 0.1, DIAGONAL, Math.toRadians(10), 0.8);

    private static final MountedCone AWAY = new MountedCone(0.125, -0.1, -DIAGONAL, Math.toRadians(10), 0.8);

    private static double expected(double wantedDistance, double... readings) {
        return expected(CONE, wantedDistance, 0, 0, readings);
    }

    /** Between two measurements the sensor moves by a step. */
    private static double expected(
            MountedCone cone, double wantedDistance, double turnRate, double step, double... readings) {
        MeasurementRing measurements = new MeasurementRing();
        double x = 0;
        for (double reading : readings) {
            measurements.add(x, 0, DIAGONAL, Math.cos(DIAGONAL), Math.sin(DIAGONAL), reading, 0);
            x += step;
        }
        return NearSurfaceCheck.expectedAhead(cone, measurements, wantedDistance, turnRate);
    }

    @Test
    void aNearSurfaceThatFacesTheSensorCrossesThePath() {
        assertEquals(0.13 * Math.sqrt(2) + 0.1, expected(0.25, 0.16, 0.145, 0.13), 1e-12);
    }

    @Test
    void aSingleNearReadingIsNoSurface() {
        assertEquals(Reading.NOTHING, expected(0.25, 0.5, 0.5, 0.13));
        assertEquals(Reading.NOTHING, expected(0.25, -1, 0.14, 0.13));
        assertEquals(Reading.NOTHING, expected(0.25, 0.14, 0.13));
    }

    @Test
    void aRobotThatKeepsNearTheWallMayComeNearer() {
        assertEquals(Reading.NOTHING, expected(0.1, 0.12, 0.11, 0.1));
        assertEquals(0.05 * Math.sqrt(2) + 0.1, expected(0.1, 0.07, 0.06, 0.05), 1e-12);
    }

    @Test
    void aSurfaceIsNearUpToFourteenCentimetres() {
        assertEquals(Reading.NOTHING, expected(0.25, 0.141, 0.141, 0.141));
        assertEquals(0.139 * Math.sqrt(2) + 0.1, expected(0.25, 0.139, 0.139, 0.139), 1e-12);
        assertEquals(Reading.NOTHING, expected(0.2, 0.113, 0.113, 0.113));
        assertEquals(0.111 * Math.sqrt(2) + 0.1, expected(0.2, 0.111, 0.111, 0.111), 1e-12);
    }

    @Test
    void measurementsAgreeWithinFiveCentimetres() {
        assertEquals(Reading.NOTHING, expected(0.25, 0.153, 0.102, 0.102));
        assertEquals(0.102 * Math.sqrt(2) + 0.1, expected(0.25, 0.151, 0.102, 0.102), 1e-12);
    }

    /** The reading of a surface that faces the sensor falls by cos 45 = 0.71 of the robot's motion. */
    @Test
    void aSurfaceBesideThePathDoesNotCrossIt() {
        assertEquals(0.11 * Math.sqrt(2) + 0.1, expected(CONE, 0.25, 0, 0.02, 0.138, 0.124, 0.11), 1e-12);
        assertEquals(Reading.NOTHING, expected(CONE, 0.25, 0, 0.02, 0.134, 0.122, 0.11));
        assertEquals(Reading.NOTHING, expected(CONE, 0.25, 0, 0.02, 0.11, 0.11, 0.11));
    }

    @ParameterizedTest
    @CsvSource({"-0.31, 0.02, false", "-0.29, 0.14, true", "0.29, 0.14, true", "0.31, 0.083, true", "0.31, 0.085, false"
    })
    void aRobotThatTurnsMayComeNearerToTheWall(double turnRate, double reading, boolean crosses) {
        double expected = crosses ? reading * Math.sqrt(2) + 0.1 : Reading.NOTHING;
        assertEquals(expected, expected(CONE, 0.25, turnRate, 0, reading, reading, reading), 1e-12);
    }

    @Test
    void onTheSideAwayFromTheWallEveryNearSurfaceCrossesThePath() {
        double crossing = 0.13 * Math.sqrt(2) + 0.1;
        assertEquals(crossing, expected(AWAY, 0.25, -0.5, 0.02, 0.13, 0.13, 0.13), 1e-12);
        assertEquals(crossing, expected(AWAY, 0.25, 0.5, 0.02, 0.13, 0.13, 0.13), 1e-12);
    }
}
