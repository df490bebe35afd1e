package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.report.Interval;
import faultline.control.PdGains;
import faultline.control.TimingRule;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.studies.CornerRun.SensorSelection;
import faultline.studies.figure.SortedSample;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Statements of docs/results.md tried at starts, angles, robots and seeds that no study has. */
class OtherWorldsTest {

    private static final int ALIGNMENTS = 150;

    /** Returns a trial from a random start with a random seed; draws are those of one generator. */
    private static AlignmentTrial trial(TimingRule rule, RobotSpec robot, double period, SplittableRandom random) {
        return trial(rule, robot, period, random, 0.55, 0.8);
    }

    /** Returns such a trial from a start between two distances of the robot's centre from the wall, metres. */
    private static AlignmentTrial trial(
            TimingRule rule, RobotSpec robot, double period, SplittableRandom random, double least, double most) {
        double slant = Degrees.toRadians(random.nextDouble(-30, 30));
        double away = random.nextDouble(least, most);
        AlignmentTrial there = AlignmentTrial.standard(rule, 0)
                .withRobot(robot)
                .withPeriod(period)
                .withSetup(AlignmentTrial.BASE.withStart(
                        new Pose(AlignmentTrial.WALL_Y, AlignmentTrial.WALL_Y - away, StrictMath.PI / 2 + slant)));
        return new AlignmentTrial(there.setup().withSeed(random.nextLong(1_000_000)), 1);
    }

    private static SortedSample errors(
            TimingRule rule, double degreesPerSecond, double period, double noiseMm, long draws) {
        return errors(rule, degreesPerSecond, period, noiseMm, draws, ALIGNMENTS);
    }

    private static SortedSample errors(
            TimingRule rule, double degreesPerSecond, double period, double noiseMm, long draws, int alignments) {
        SplittableRandom random = new SplittableRandom(draws);
        RobotSpec robot = SetupVariations.withNoise(
                AlignmentTrial.robot(0.8, Degrees.toRadians(20), Degrees.toRadians(degreesPerSecond), 0.05),
                noiseMm / 1000);
        return SortedSample.of(IntStream.range(0, alignments)
                .mapToObj(i -> trial(rule, robot, period, random).run())
                .flatMap(result -> result.stream())
                .mapToDouble(result -> Math.toDegrees(result.headingError())));
    }

    private static DoubleStream cornerErrors(double degrees, SensorSelection sensors) {
        return IntStream.range(40, 71)
                .mapToObj(start -> CornerRun.distanceError(degrees, sensors, start))
                .flatMapToDouble(found -> found.stream());
    }

    /**
     * Statement 2: an acute corner and its mirror image cause the same error, and the sensor on the other side corrects
     * it.
     */
    @ParameterizedTest
    @CsvSource({"40, FRONT_RIGHT", "52, FRONT_RIGHT", "128, FRONT_LEFT", "132, FRONT_LEFT"})
    void twoSensorsStopTooNearToASlantedSecondWall(double degrees, SensorSelection third) {
        double two = SortedSample.of(cornerErrors(degrees, SensorSelection.TWO)).median();
        double three = SortedSample.of(cornerErrors(degrees, third)).median();
        assertTrue(two < -40 && two > -125, degrees + " degrees: " + two + " mm");
        assertEquals(0, three, 6, degrees + " degrees with " + third);
    }

    /** Statement 4: the error grows with the noise, and gross errors come with long control periods. */
    @Test
    void noiseCostsTenthsOfADegreeAtAShortPeriodAndGrossErrorsAtALongOne() {
        SortedSample little = errors(TimingRule.EQUAL_READINGS, 60, 0.01, 4, 81);
        SortedSample much = errors(TimingRule.EQUAL_READINGS, 60, 0.01, 10, 82);
        SortedSample slow = errors(TimingRule.EQUAL_READINGS, 60, 0.05, 10, 83);
        assertTrue(little.rms() < 0.6 && much.rms() < 1.5, little.rms() + " and " + much.rms());
        assertTrue(little.rms() < much.rms());
        assertEquals(0, little.countBeyond(5));
        assertTrue(much.countBeyond(5) <= 3, "about one gross error in 300: " + much.countBeyond(5));
        int gross = slow.countBeyond(5);
        assertTrue(gross >= 2 && gross <= ALIGNMENTS / 5, gross + " of " + slow.size());
    }

    /** Statement 5: noise disturbs the range rule at low spin rates only. */
    @Test
    void theRangeRuleFailsWithNoiseWhenTheRobotSpinsSlowly() {
        SortedSample slow = errors(TimingRule.RANGE, 15, 0.01, 8, 84);
        int gross = slow.countBeyond(5);
        assertTrue(gross >= ALIGNMENTS / 12 && gross <= ALIGNMENTS / 3, gross + " of " + slow.size());
        assertTrue(slow.max() > 60, "they are some 75 degrees off: " + slow.max());
        int fast = errors(TimingRule.RANGE, 60, 0.01, 8, 85).countBeyond(5);
        assertTrue(fast <= 3 && 8 * fast <= gross, fast + " at 60 degrees a second");
    }

    /** Statement 6: a wrong speed of the wheels cancels with equal readings. */
    @ParameterizedTest
    @CsvSource({"0.87, 0.87", "1.13, 1.13", "1.04, 0.93"})
    void aWrongSpeedOfTheWheelsHardlyTurnsTheRobot(double left, double right) {
        SplittableRandom random = new SplittableRandom(86);
        RobotSpec robot = AlignmentTrial.BASE.robot().withDriveScale(new DriveScale(left, right, 1));
        for (int i = 0; i < 12; i++) {
            AlignmentTrial trial = trial(TimingRule.EQUAL_READINGS, robot, 0.01, random);
            assertEquals(0, Math.toDegrees(trial.run().orElseThrow().headingError()), 0.3, "start " + i);
        }
    }

    @Test
    void theResultsGiveTheGrossErrorsAtSixHundredOtherStarts() throws IOException {
        int equal = errors(TimingRule.EQUAL_READINGS, 60, 0.01, 10, 82, 600).countBeyond(5);
        int exact = errors(TimingRule.RANGE, 60, 0.01, 8, 85, 600).countBeyond(5);
        assertSaid(
                "%d of 600 (%s) with equal readings at 10 mm, %d of 600 (%s) by the range rule at 8 mm",
                equal, interval(equal, 600), exact, interval(exact, 600));
    }

    /** Right wheels that are faster or slower by a fifth bend the path to the wall. */
    @Test
    void theResultsGiveTheErrorsOfUnequalWheelsAtOtherStarts() throws IOException {
        SortedSample near = errorsOfUnequalWheels(0.55, 0.8);
        SortedSample far = errorsOfUnequalWheels(0.8, 1.2);
        assertSaid(
                "%d of %d alignments with equal readings (%s) are off by more than 0.06 degrees if the robot starts"
                        + " 0.55 to 0.8 m from the wall, by at most %.1f, and %d of %d (%s) from 0.8 to 1.2 m, by up to"
                        + " %.1f",
                near.countBeyond(0.06),
                near.size(),
                interval(near.countBeyond(0.06), near.size()),
                Math.max(near.max(), -near.quantile(0)),
                far.countBeyond(0.06),
                far.size(),
                interval(far.countBeyond(0.06), far.size()),
                Math.max(far.max(), -far.quantile(0)));
    }

    private static SortedSample errorsOfUnequalWheels(double least, double most) {
        SplittableRandom random = new SplittableRandom(86);
        RobotSpec robot = AlignmentTrial.BASE.robot();
        return SortedSample.of(IntStream.range(0, 600)
                .mapToObj(i -> robot.withDriveScale(new DriveScale(1, i % 2 == 0 ? 1.2 : 0.8, 1)))
                .map(unequal -> trial(TimingRule.EQUAL_READINGS, unequal, 0.01, random, least, most)
                        .run())
                .flatMap(result -> result.stream())
                .mapToDouble(result -> Math.toDegrees(result.headingError())));
    }

    private static String interval(int hits, int trials) {
        Interval interval = Interval.wilson(hits, trials);
        return String.format(Locale.ROOT, "%.1f to %.1f %%", 100 * interval.low(), 100 * interval.high());
    }

    private static void assertSaid(String sentence, Object... numbers) throws IOException {
        String said = String.format(Locale.ROOT, sentence, numbers);
        String text = Files.readString(Path.of("docs/results.md")).replaceAll("\\s+", " ");
        assertTrue(text.contains(said), () -> "the results should say: " + said);
    }

    /** Statement 7: the P term is clamped. */
    @Test
    void thePTermIsClampedAtTheErrorOfAnApproachAtThirtyDegrees() {
        for (double speed : new double[] {0.17, 0.42}) {
            PdGains gains = PdGains.withErrorLimit(70, 19, speed);
            double limit = gains.derivative() * speed * 0.5 / gains.proportional();
            assertEquals(gains.proportionalTerm(limit), gains.proportionalTerm(3 * limit), 1e-12);
            assertEquals(gains.proportionalTerm(limit) / 2, gains.proportionalTerm(limit / 2), 1e-12);
        }
    }

    /** Statement 7: the line of stability is close for small k_d and some 20 % too low for large ones. */
    @ParameterizedTest
    @CsvSource({"7, 0.85, 1.2", "93, 1.08, 1.45"})
    void theLineOfStabilityIsAnApproximation(double kd, double low, double high) {
        double line = kd / (0.05 + 1.5 * PdLoop.TICK);
        double stable = line / 3;
        double swinging = line * 3;
        while (swinging / stable > 1.01) {
            double kp = Math.sqrt(stable * swinging);
            boolean swings = isSwinging(kp, kd);
            stable = swings ? stable : kp;
            swinging = swings ? kp : swinging;
        }
        double ratio = stable / line;
        assertTrue(ratio > low && ratio < high, ratio + " times the line");
    }

    /** Whether a small disturbance is still there after ten seconds. */
    private static boolean isSwinging(double kp, double kd) {
        List<Double> errors = new PdLoop(new PdGains(kp, kd, 1), 0.002, 0).errors();
        List<Double> late = errors.subList(errors.size() * 3 / 4, errors.size());
        return late.stream().anyMatch(error -> Math.abs(error) > 0.001);
    }

    /** Statement 7: near the limit of stability the distance settles while the heading still chatters. */
    @Test
    void withLargeGainsTheDistanceSettlesWhileTheHeadingChatters() {
        assertEquals(PdLoop.LoopResponse.SETTLES, loop(1300, 94).response());
        assertTrue(chatter(1300, 94) > 5e-5, chatter(1300, 94) + " m a tick");
        assertTrue(chatter(300, 94) < 1e-9, chatter(300, 94) + " m a tick");
    }

    private static PdLoop loop(double kp, double kd) {
        return new PdLoop(PdGains.withErrorLimit(kp, kd, PdLoop.SPEED), 0, Degrees.toRadians(45));
    }

    /** The greatest change of the distance from tick to tick in the last two seconds, metres. */
    private static double chatter(double kp, double kd) {
        List<Double> errors = loop(kp, kd).errors();
        double most = 0;
        for (int i = errors.size() - (int) (2 / PdLoop.TICK); i < errors.size(); i++) {
            most = Math.max(most, Math.abs(errors.get(i) - errors.get(i - 1)));
        }
        return most;
    }

    /** Statement 9: all quantities at once, by other draws, and theory as one line of arithmetic. */
    @Test
    void allQuantitiesAtOnceGiveTheErrorsOfTheory() {
        SplittableRandom random = new SplittableRandom(87);
        for (int i = 0; i < 60; i++) {
            double rate = Degrees.toRadians(random.nextDouble(20, 120));
            double lag = random.nextDouble(0, 0.12);
            double period = 0.002 * random.nextInt(1, 11);
            double cone = Degrees.toRadians(random.nextDouble(4, 50));
            RobotSpec robot = AlignmentTrial.robot(random.nextDouble(0.7, 1.5), cone, rate, lag);
            SplittableRandom starts = random.split();
            String what = "trial " + i + ": " + Math.toDegrees(rate) + " deg/s, " + lag + " s, " + period + " s";
            double equal = trial(TimingRule.EQUAL_READINGS, robot, period, starts)
                    .run()
                    .orElseThrow()
                    .headingError();
            assertEquals(0, Math.toDegrees(equal), 0.3, what);
            double exact = trial(TimingRule.RANGE, robot, period, starts)
                    .run()
                    .orElseThrow()
                    .headingError();
            double theory = -rate * (lag + period / 2);
            assertEquals(Math.toDegrees(theory), Math.toDegrees(exact), Math.toDegrees(rate * period / 2) + 0.35, what);
        }
    }
}
