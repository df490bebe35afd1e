package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.SensorFinding;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SignalCheckTest {

    private final SplittableRandom random = new SplittableRandom(1);

    private static SensorFinding run(int sensor, int ticks, double rolled, double turned, IntToDoubleFunction reading) {
        MotionAccumulator motion = new MotionAccumulator();
        SignalCheck test =
                new SignalCheck(MountedCone.of(RobotSpec.DEFAULT.sensors().get(sensor), 1), motion);
        SensorFinding finding = SensorFinding.NONE;
        for (int i = 0; i < ticks; i++) {
            motion.advance(rolled, turned);
            finding = test.test(reading.applyAsDouble(i));
        }
        return finding;
    }

    @Test
    void aSensorWithoutAnAnswerIsOff() {
        assertEquals(SensorFinding.OFF, run(0, 1, 0, 0, i -> Reading.OFF));
    }

    @Test
    void aConstantReadingInATurnIsStuck() {
        assertEquals(SensorFinding.STUCK, run(2, 30, 0, 0.01, i -> 0.25));
        assertEquals(SensorFinding.NONE, run(2, 15, 0, 0.01, i -> 0.25));
    }

    @Test
    void aConstantReadingBesideAStraightWallIsNot() {
        assertEquals(SensorFinding.NONE, run(2, 1000, 0.003, 0, i -> 0.25));
    }

    @Test
    void aConstantReadingAheadOfARollingRobotIsStuck() {
        assertEquals(SensorFinding.STUCK, run(0, 30, 0.003, 0, i -> 0.25));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.008})
    void usualNoiseIsNoFinding(double noise) {
        assertEquals(SensorFinding.NONE, run(2, 2000, 0.003, 0, i -> 0.25 + noise * random.nextGaussian()));
    }

    @Test
    void strongNoiseIsFound() {
        assertEquals(SensorFinding.NOISY, run(2, 200, 0.003, 0, i -> 0.3 + 0.05 * random.nextGaussian()));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.03, 0.1})
    void rareGhostsAreFoundWithinSeconds(double share) {
        IntToDoubleFunction ghosts = i -> Math.min(
                0.25 + 0.002 * random.nextGaussian(), random.nextDouble() < share ? 0.2 * random.nextDouble() : 1);
        assertEquals(SensorFinding.NOISY, run(2, 800, 0.003, 0, ghosts));
    }

    @Test
    void anEdgeThatFlickersIsNoGhost() {
        // As the left sensor reads beside a corner: the nearer surface for a tick, the farther one for some.
        assertEquals(SensorFinding.NONE, run(2, 3000, 0.003, 0, i -> i % 12 == 0 ? 0.2 + 0.001 * (i / 12 % 10) : 0.27));
    }

    @Test
    void readingsThatComeAndGoAreFoundUnlessTheyAreNearTheRange() {
        assertEquals(SensorFinding.INTERMITTENT, run(2, 50, 0.003, 0, i -> i % 2 == 0 ? 0.3 : Reading.NOTHING));
        assertEquals(SensorFinding.NONE, run(2, 50, 0.003, 0, i -> i % 2 == 0 ? 0.79 : Reading.NOTHING));
    }
}
