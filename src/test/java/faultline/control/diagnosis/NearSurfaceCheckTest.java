package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NearSurfaceCheckTest {

    private static final double DIAGONAL = Math.toRadians(45);
    private static final MountedCone CONE = new MountedCone(0.125, 0.1, DIAGONAL, Math.toRadians(10), 0.8);

    private static double expected(double wantedDistance, double... readings) {
        MeasurementRing measurements = new MeasurementRing();
        for (double reading : readings) {
            measurements.add(0, 0, DIAGONAL, Math.cos(DIAGONAL), Math.sin(DIAGONAL), reading, 0);
        }
        return NearSurfaceCheck.expectedAhead(CONE, measurements, wantedDistance);
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

    @ParameterizedTest
    @CsvSource({
        "0, false",
        "20, false",
        "23, true",
        "-23, true",
        "45, true",
        "-45, true",
        "68, true",
        "70, false",
        "180, false"
    })
    void itAppliesToSensorsThatLookDiagonallyAhead(double degrees, boolean applies) {
        MountedCone cone = new MountedCone(0, 0, Math.toRadians(degrees), Math.toRadians(10), 0.8);
        assertEquals(applies, NearSurfaceCheck.applies(cone));
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
        assertEquals(Reading.NOTHING, expected(0.25, 0.051, 0.102, 0.102));
        assertEquals(0.102 * Math.sqrt(2) + 0.1, expected(0.25, 0.053, 0.102, 0.102), 1e-12);
    }
}
