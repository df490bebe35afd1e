package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.geometry.Vector2;
import org.junit.jupiter.api.Test;

/** The values of a sensor: their limits, and copies with one of them changed. */
class SensorSpecTest {

    static final SensorSpec LEFT = new SensorSpec("left", new Vector2(0.1, 0.2), 1.5, 0.8, 0.3, true, 0.01);

    @Test
    void aCopyDiffersInOneValue() {
        assertEquals(new SensorSpec("left", new Vector2(0.1, 0.2), 1.5, 0.8, 0.3, false, 0.01), LEFT.withOn(false));
        assertEquals(new SensorSpec("left", new Vector2(0.1, 0.2), 1.5, 2, 0.3, true, 0.01), LEFT.withRange(2));
        assertEquals(new SensorSpec("left", new Vector2(0.1, 0.2), 1.5, 0.8, 1, true, 0.01), LEFT.withCone(1));
        assertEquals(
                new SensorSpec("left", new Vector2(3, 4), 1.5, 0.8, 0.3, true, 0.01),
                LEFT.withMountPosition(new Vector2(3, 4)));
        assertEquals(new SensorSpec("left", new Vector2(0.1, 0.2), -1, 0.8, 0.3, true, 0.01), LEFT.withBearing(-1));
        assertEquals(new SensorSpec("left", new Vector2(0.1, 0.2), 1.5, 0.8, 0.3, true, 0), LEFT.withNoise(0));
    }

    @Test
    void rangeAndNoiseAreWithinTheirLimits() {
        assertEquals(
                SensorLimits.MIN_RANGE, LEFT.withRange(SensorLimits.MIN_RANGE).range());
        assertEquals(
                SensorLimits.MAX_RANGE, LEFT.withRange(SensorLimits.MAX_RANGE).range());
        assertEquals(
                SensorLimits.MAX_NOISE, LEFT.withNoise(SensorLimits.MAX_NOISE).noise());
        for (double range : new double[] {0, -1, Math.nextUp(SensorLimits.MAX_RANGE), Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> LEFT.withRange(range), range + " m");
        }
        for (double noise : new double[] {-1e-9, Math.nextUp(SensorLimits.MAX_NOISE), Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> LEFT.withNoise(noise), noise + " m");
        }
    }

    @Test
    void aConeIsMoreThanNothingAndLessThanAHalfPlane() {
        assertEquals(
                Math.nextDown(Math.PI), LEFT.withCone(Math.nextDown(Math.PI)).cone());
        for (double cone : new double[] {0, Math.PI, -0.1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> LEFT.withCone(cone), cone + " rad");
        }
    }

    @Test
    void aSensorHasAnIdAndAFinitePlace() {
        Vector2 place = new Vector2(0, 0);
        assertThrows(IllegalArgumentException.class, () -> new SensorSpec("", place, 0, 1, 1, true, 0));
        for (double bearing : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> LEFT.withBearing(bearing), bearing + " rad");
        }
        assertFalse(LEFT.withBearing(7).bearing() < 7, "a bearing is kept as it is given");
    }
}
