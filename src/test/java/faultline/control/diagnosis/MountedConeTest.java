package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.control.WallSide;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
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

    @ParameterizedTest
    @CsvSource({"1.25, 0.75", "2.5, 2", "0.5, 0"})
    void itsRangeIsLimitedByTheDistanceFromTheCentre(double distance, double expected) {
        // Wherever a sensor 0.5 m from the centre looks, it reaches no farther than 0.5 m more.
        MountedCone cone = new MountedCone(-0.3, 0.4, 0, HALF, 2);
        assertEquals(expected, cone.rangeWithin(distance), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({"LEFT, 45, 45", "RIGHT, 45, -45", "RIGHT, -90, 90", "LEFT, 180, 180", "RIGHT, 180, 180"})
    void theWallIsOnItsLeftOnEitherSide(WallSide side, double degrees, double bearing) {
        SensorSpec sensor = RobotSpec.DEFAULT.sensors().get(0).withMountPosition(new Vector2(0.1, 0.05));
        MountedCone cone = MountedCone.of(sensor.withBearing(Degrees.toRadians(degrees)), side);
        assertEquals(Math.toRadians(bearing), cone.bearing(), 1e-12);
        assertEquals(0.1, cone.x());
        assertEquals(side == WallSide.LEFT ? 0.05 : -0.05, cone.y());
    }
}
