package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.WallSide;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.EnumSet;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SignalCheckTest {

    private final SplittableRandom random = new SplittableRandom(1);

    private static SensorFinding run(int sensor, int ticks, double rolled, double turned, IntToDoubleFunction reading) {
        MotionAccumulator motion = new MotionAccumulator();
        SignalCheck test =
                new SignalCheck(MountedCone.of(RobotSpec.DEFAULT.sensors().get(sensor), WallSide.LEFT), motion);
        SensorFinding finding = SensorFinding.NONE;
        for (int i = 0; i < ticks; i++) {
            motion.advance(rolled, turned, 0.01);
            finding = process(test, reading.applyAsDouble(i));
        }
        return finding;
    }

    private static SensorFinding process(SignalCheck check, double reading) {
        return check.continues(reading) ? SensorFinding.NONE : check.test(reading);
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
    void aConstantReadingIsNotStuckInATurnThatUnequalWheelsExplain() {
        assertEquals(SensorFinding.NONE, run(2, 1000, 0.003, 0.0017, i -> 0.25));
        assertEquals(SensorFinding.STUCK, run(2, 1000, 0.003, 0.0035, i -> 0.25));
    }

    @Test
    void aConstantReadingBesideAStraightWallIsNot() {
        assertEquals(SensorFinding.NONE, run(2, 1000, 0.003, 0, i -> 0.25));
    }

    /**
     * Returns the number of readings until a sensor is found stuck if the turn of a step goes up and down, 0 if never.
     */
    private static int stepsUntilStuck(MountedCone cone, double turned, int coarseness) {
        MotionAccumulator motion = new MotionAccumulator();
        SignalCheck test = new SignalCheck(cone, motion);
        for (int i = 0; i < 2000; i++) {
            motion.advance(0.003, i % 2 == 0 ? turned : -turned, 0.01);
            // Coarse steps at first, and then none.
            double reading = 0.25 + 0.001 * Math.min(i / coarseness, 3);
            if (process(test, reading) == SensorFinding.STUCK) {
                return i - 3 * coarseness;
            }
        }
        return 0;
    }

    @Test
    void aConstantReadingIsStuckIfTheRobotSteers() {
        MountedCone left = MountedCone.of(RobotSpec.DEFAULT.sensors().get(2), WallSide.LEFT);
        assertEquals(20, stepsUntilStuck(left, 1e-5, 1));
        // 2e-7 for each of 51 steps.
        assertEquals(51, stepsUntilStuck(left, 1e-7, 1));
        assertEquals(0, stepsUntilStuck(left, 0, 1));
    }

    @Test
    void aSensorOfCoarseStepsMustReadTheSameForTwiceAsLongAsBefore() {
        MountedCone left = MountedCone.of(RobotSpec.DEFAULT.sensors().get(2), WallSide.LEFT);
        // Ten readings are the same for nine steps after the first.
        assertEquals(20, stepsUntilStuck(left, 0x1p-17, 10));
        assertEquals(29, stepsUntilStuck(left, 0x1p-17, 15));
    }

    @Test
    void aSensorInTheCentreOfTheRobotMayReadTheSameInATurn() {
        SensorSpec left = RobotSpec.DEFAULT.sensors().get(2);
        MountedCone centred = MountedCone.of(left.withMountPosition(Vector2.ZERO), WallSide.LEFT);
        assertEquals(0, stepsUntilStuck(centred, 1e-5, 1));
    }

    @Test
    void aConstantReadingAheadOfARollingRobotIsStuck() {
        assertEquals(SensorFinding.STUCK, run(0, 30, 0.003, 0, i -> 0.25));
    }

    /** The border of a cone of 20 degrees is beside the path by 0.174 of the reading. */
    @Test
    void aConstantReadingAheadOfARollingRobotMayBeThatOfAWallAlongThePath() {
        assertEquals(SensorFinding.STUCK, run(0, 30, 0.003, 0, i -> 0.8));
        assertEquals(SensorFinding.NONE, run(0, 1000, 0.003, 0, i -> 0.9));
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

    /** Runs beside a robot that stands, so that motion explains nothing; the left sensor reads 0.3 m. */
    private static SensorFinding runStanding(int ticks, IntToDoubleFunction reading) {
        return run(2, ticks, 0, 0, reading);
    }

    @ParameterizedTest
    @CsvSource({
        "0.3, 0.3, 0.346, true",
        "0.3, 0.3, 0.344, false",
        "0.3, 0.3, 0.254, true",
        "0.3, 0.32, 0.34, false",
        "0.3, 0.35, 0.40, false",
        "0.3, 0.32, 0.386, true",
        "0.3, 0.35, 0.35, true",
        "0.3, 0.3, Infinity, false",
        "Infinity, 0.3, 0.3, false",
        "0.3, 0.3, NaN, false"
    })
    void aReadingJumpsIfItDiffersFromTheExtrapolation(double one, double two, double three, boolean jumps) {
        SignalCheck check = new SignalCheck(
                MountedCone.of(RobotSpec.DEFAULT.sensors().get(2), WallSide.LEFT), new MotionAccumulator());
        check.test(one);
        check.test(two);
        check.test(three);
        assertEquals(jumps, check.jumped());
    }

    @ParameterizedTest
    @CsvSource({"20, NONE", "17, NONE", "14, NOISY", "10, NOISY"})
    void aQuarterOfAllDifferencesMayScatter(int period, SensorFinding expected) {
        // A single longer reading makes four large third differences.
        assertEquals(expected, runStanding(1500, i -> i % period == 0 ? 0.4 : 0.3));
    }

    @Test
    void scatterIsForgotten() {
        IntToDoubleFunction reading = i -> i < 400 && i % 10 == 0 ? 0.4 : 0.3 + (i & 1) * 1e-4;
        assertEquals(SensorFinding.NOISY, runStanding(395, reading));
        assertEquals(SensorFinding.NONE, runStanding(480, reading));
    }

    @ParameterizedTest
    @CsvSource({
        // The spikes after each other, the reading after each, and the period; the other readings are 0.3 m.
        "0.2 0.15 0.1 0.05, 0.3, 50, NOISY",
        "0.2 0.15 0.1, 0.3, 50, NONE",
        "0.2 0.15 0.1 0.05, 0.3, 300, NONE",
        "0.2 0.2 0.2 0.2 0.2, 0.3, 50, NONE",
        "0.2 0.17 0.2 0.17, 0.3, 50, NOISY",
        "0.255 0.2 0.255 0.2, 0.3, 50, NOISY",
        "0.265 0.23 0.265 0.23, 0.3, 50, NONE",
        "0.2 0.15 0.1 0.05, 0.275, 50, NONE",
        "0.2 0.15 0.1 0.05, 0.325, 50, NONE"
    })
    void threeShortReadingsThatDifferFromTheShortOneBeforeAreGhosts(
            String spikes, double after, int period, SensorFinding expected) {
        String[] lengths = spikes.split(" ");
        SensorFinding found = runStanding(lengths.length * period + 2, i -> {
            boolean isSpike = i > 0 && i % period == 0;
            boolean isAfter = i > period && i % period == 1;
            return isSpike ? Double.parseDouble(lengths[i / period - 1]) : isAfter ? after : 0.3;
        });
        assertEquals(expected, found);
    }

    @ParameterizedTest
    @CsvSource({
        "0.3, 4, 4, INTERMITTENT",
        "0.3, 3, 4, NONE",
        "0.3, 4, 30, NONE",
        "0.69, 4, 4, INTERMITTENT",
        "0.71, 8, 4, NONE"
    })
    void aSurfaceThatVanishesFourTimesInASecondIsIntermittent(
            double distance, int times, int period, SensorFinding expected) {
        assertEquals(expected, runStanding(times * period, i -> i % period == period - 1 ? Reading.NOTHING : distance));
    }

    @Test
    void whatComesAndGoesIsForgotten() {
        IntToDoubleFunction reading = i -> i < 40 && i % 4 == 3 ? Reading.NOTHING : 0.3 + (i & 1) * 1e-4;
        assertEquals(SensorFinding.INTERMITTENT, runStanding(40, reading));
        assertEquals(SensorFinding.INTERMITTENT, runStanding(100, reading));
        assertEquals(SensorFinding.NONE, runStanding(300, reading));
    }

    @ParameterizedTest
    @CsvSource({
        // sensor, ticks, rolled, turned, reading
        "0, 18, 0.003, 0, 0.3, STUCK",
        "0, 17, 0.003, 0, 0.3, NONE",
        "0, 18, -0.003, 0, 0.3, STUCK",
        "1, 100, 0.003, 0, 0.3, NONE",
        "4, 100, 0.003, 0, 0.3, NONE",
        "2, 22, 0, 0.01, 0.3, STUCK",
        "2, 21, 0, 0.01, 0.3, NONE",
        "2, 22, 0, -0.01, 0.3, STUCK",
        "2, 18, 0.003, 0, 0, STUCK",
        "2, 17, 0.003, 0, 0, NONE",
        "2, 12, 0.003, 0.002, 0, STUCK",
        "2, 12, 0.003, -0.002, 0, STUCK",
        "2, 100, 0.003, 0, 0.001, NONE",
        "2, 100, 0, 0.01, Infinity, NONE",
        "0, 100, 0.003, 0, Infinity, NONE"
    })
    void aConstantReadingIsStuckOnceMotionShouldHaveChangedIt(
            int sensor, int ticks, double rolled, double turned, double reading, SensorFinding expected) {
        assertEquals(expected, run(sensor, ticks, rolled, turned, i -> reading));
    }

    @Test
    void anyChangeOfTheReadingBeginsAgain() {
        assertEquals(SensorFinding.NONE, run(2, 100, 0, 0.01, i -> i / 20 % 2 == 0 ? 0.3 : 0.3001));
        assertEquals(SensorFinding.NONE, run(2, 62, 0, 0.01, i -> i == 60 ? 0.31 : 0.3));
    }

    @Test
    void aSensorThatAnswersAgainIsTestedFromThenOn() {
        assertEquals(SensorFinding.NONE, runStanding(60, i -> i == 50 ? Reading.OFF : 0.3));
        assertEquals(SensorFinding.OFF, runStanding(51, i -> i == 50 ? Reading.OFF : 0.3));
        assertEquals(SensorFinding.OFF, runStanding(51, i -> i == 50 ? Reading.OFF : Reading.NOTHING));
    }

    @Test
    void polesThatARobotPassesAreNeitherGhostsNorNoise() {
        // Each pole is in view for 24 ticks: 7 cm.
        IntToDoubleFunction poles = i -> i % 40 < 24 ? 0.25 - 0.03 * (i / 40 % 2) + 1e-4 * (i & 1) : Reading.NOTHING;
        assertEquals(SensorFinding.NONE, run(2, 2000, 0.003, 0, poles));
        assertEquals(SensorFinding.INTERMITTENT, run(2, 2000, 0.0005, 0, poles));
    }

    @ParameterizedTest
    @CsvSource({"0.06, NONE", "0.003, NOISY"})
    void polesThatPassBetweenTwoReadingsAreNoGhosts(double rolled, SensorFinding expected) {
        // At 0.2 m the cone is 6.9 cm wide.
        double[] poles = {0.2, 0.15, 0.1, 0.05};
        IntToDoubleFunction reading = i -> i > 0 && i % 50 == 0 ? poles[i / 50 - 1] : 0.3;
        assertEquals(expected, run(2, 202, rolled, 0, reading));
    }

    @ParameterizedTest
    @CsvSource({"0.06, NONE", "0.003, NOISY"})
    void closePolesThatPassBetweenTwoReadingsAreNoNoise(double rolled, SensorFinding expected) {
        assertEquals(expected, run(2, 300, rolled, 0, i -> i % 3 == 2 ? 0.2 : 0.3));
    }

    /** Returns readings that are smooth for a while, then step, scatter, stay the same or see nothing. */
    private static double[] changingReadings(SplittableRandom random, int count) {
        double[] readings = new double[count];
        double reading = 0.4;
        double slope = 0;
        int mode = 0;
        for (int i = 0; i < count; i++) {
            if (random.nextInt(40) == 0) {
                mode = random.nextInt(7);
                slope = random.nextDouble(-0.003, 0.003);
            }
            reading = Math.min(0.8, Math.max(0.05, reading + slope));
            readings[i] = switch (mode) {
                case 0 -> Reading.NOTHING;
                case 1 -> random.nextInt(9) == 0 ? Reading.NOTHING : reading;
                case 2 -> reading + random.nextDouble(-0.15, 0.15);
                case 3 -> i > 0 ? readings[i - 1] : reading;
                case 4 -> random.nextInt(30) == 0 ? Reading.OFF : reading;
                default -> reading;
            };
        }
        return readings;
    }

    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
    void readingsThatNeedNoTestWouldPassIt(long seed) {
        MotionAccumulator motion = new MotionAccumulator();
        MountedCone cone = MountedCone.of(RobotSpec.DEFAULT.sensors().get(1), WallSide.LEFT);
        SignalCheck check = new SignalCheck(cone, motion);
        SignalCheck judge = new SignalCheck(cone, motion);
        SplittableRandom changes = new SplittableRandom(seed);
        Set<SensorFinding> findings = EnumSet.noneOf(SensorFinding.class);
        int untested = 0;
        int count = 20_000;
        for (double reading : changingReadings(changes, count)) {
            motion.advance(0.003, changes.nextDouble(-1e-3, 1e-3), 0.01);
            SensorFinding expected = judge.test(reading);
            boolean continued = check.continues(reading);
            SensorFinding actual = continued ? SensorFinding.NONE : check.test(reading);
            assertEquals(expected, actual);
            assertEquals(judge.jumped(), !continued && check.jumped());
            findings.add(actual);
            untested += continued ? 1 : 0;
        }
        assertTrue(untested > count / 5, untested + " readings need no test");
        assertTrue(findings.size() >= 4, () -> "findings " + findings);
    }
}
