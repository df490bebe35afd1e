package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MountedConeTest {

    private static final double HALF = Math.toRadians(10);

    private static MountedCone cone(double bearing) {
        return new MountedCone(0, 0, bearing, HALF, 0.8);
    }

    @ParameterizedTest
    @CsvSource({
        "0, true, false",
        "9, true, false",
        "-9, true, false",
        "11, false, true",
        "-11, false, true",
        "90, false, true",
        "180, false, true"
    })
    void straightAheadIsInsideOrOutside(double degrees, boolean ahead, boolean aside) {
        assertEquals(ahead, cone(Math.toRadians(degrees)).looksAhead());
        assertEquals(aside, cone(Math.toRadians(degrees)).looksAside());
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 1})
    void theBorderIsNeither(int side) {
        MountedCone cone = cone(side * HALF);
        assertFalse(cone.looksAhead());
        assertFalse(cone.looksAside());
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
        "-68, true",
        "70, false",
        "-70, false",
        "180, false"
    })
    void itLooksDiagonallyIfItsBorderIsBesideStraightAheadAndItIsNotSideways(double degrees, boolean diagonally) {
        assertEquals(diagonally, cone(Math.toRadians(degrees)).looksDiagonally());
    }
}
