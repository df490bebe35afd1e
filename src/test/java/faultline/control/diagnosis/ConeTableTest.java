package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConeTableTest {

    @ParameterizedTest
    @CsvSource({"0, 10, 0", "45, 10, 35", "-45, 10, 35", "90, 25, -60", "-135, 5, 170"})
    void directionsAreThoseOfEvenlySpacedRays(double bearing, double half, double heading) {
        ConeTable table = new ConeTable(new MountedCone(0, 0, Math.toRadians(bearing), Math.toRadians(half), 1));
        double h = Math.toRadians(heading);
        double axisCos = table.axisCos(Math.cos(h), Math.sin(h));
        double axisSin = table.axisSin(Math.cos(h), Math.sin(h));
        for (int i = 0; i < ConeTable.SAMPLES; i++) {
            double degrees = heading + bearing + half * (i - 3) / 3;
            assertEquals(Math.cos(Math.toRadians(degrees)), table.cos(i, axisCos, axisSin), 1e-12);
            assertEquals(Math.sin(Math.toRadians(degrees)), table.sin(i, axisCos, axisSin), 1e-12);
            assertEquals(i == 0 ? -1 : i == 6 ? 1 : 0, ConeTable.outward(i));
        }
        double inner = Math.toRadians(Math.abs(bearing) - half);
        assertEquals(Math.cos(inner), table.innerCos(), 1e-12);
        assertEquals(Math.sin(inner), table.innerSin(), 1e-12);
        assertEquals(Math.cos(Math.toRadians(half)), table.cosHalf(), 1e-12);
    }
}
