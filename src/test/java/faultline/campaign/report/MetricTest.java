package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.report.ControllerRuns.ComparedRun;
import faultline.campaign.report.ControllerRuns.RunPair;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The numbers by which controllers are compared, and their intervals. */
class MetricTest {

    private static final ComparedRun RESTING = run(0);
    private static final ComparedRun COLLIDING = run(6);

    /** A run at some volts towards a wall at a distance of 0.275 m. */
    private static ComparedRun run(double volts) {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(3, 2, true, 0, List.of()), new Pose(2.6, 1, 0))
                .withController(new ControllerSpec.Drive(volts, volts))
                .withDuration(1);
        RunResult result = HeadlessRun.run(setup, ControllerMode.DIRECT, List.of());
        return ComparedRun.of(result, List.of(), volts / 10);
    }

    @Test
    void aShareHasTheIntervalOfWilson() {
        assertEquals("0.67 [0.21, 0.94]", Metric.COLLISION.summary(new double[] {1, 0, 1}, 3));
    }

    /** The deviation of 1 and 3 is the square root of 2, so half the interval is Student's quantile itself, 12.706. */
    @Test
    void aMeanHasTheIntervalOfStudent() {
        assertEquals("2.00 [-10.71, 14.71]", Metric.PATH.summary(new double[] {1, 3}, 2));
        // The deviation is 1, and half the interval is 4.303 divided by the square root of 3.
        assertEquals("2.00 [-0.48, 4.48]", Metric.PATH.summary(new double[] {1, 2, 3}, 3));
        assertEquals("3.00", Metric.PATH.summary(new double[] {3}, 1));
        assertEquals("none", Metric.PATH.summary(new double[] {}, 0));
    }

    /** A run that followed no wall has no coverage, and a mean without it is that of the better runs. */
    @Test
    void aMeanOfSomeOfTheRunsNamesTheirNumber() {
        assertEquals("0.377 (n = 1)", Metric.COVERAGE.summary(new double[] {0.377}, 2));
        assertEquals("2.00 [-10.71, 14.71] (n = 2)", Metric.PATH.summary(new double[] {1, 3}, 8));
        assertEquals("none", Metric.COVERAGE.summary(List.of(RESTING, COLLIDING)));
    }

    @Test
    void aDifferenceIsThatOfTheRunFromThePartner() {
        RunPair worse = new RunPair(COLLIDING, RESTING);
        RunPair equal = new RunPair(RESTING, RESTING);
        assertEquals("0.75 [0.09, 0.95]", Metric.COLLISION.difference(List.of(worse, worse, worse, equal)));
        RunPair better = new RunPair(RESTING, COLLIDING);
        assertEquals("-0.75 [-0.95, -0.09]", Metric.COLLISION.difference(List.of(better, better, better, equal)));
        RunPair both = new RunPair(COLLIDING, COLLIDING);
        assertEquals("0.75 [0.09, 0.95]", Metric.COLLISION.difference(List.of(worse, worse, worse, both)));
        assertEquals("1.00", Metric.COLLISION.difference(List.of(worse)));
        assertEquals("0.60 [0.60, 0.60]", Metric.PATH.difference(List.of(worse, worse)));
        assertEquals("none", Metric.COVERAGE.difference(List.of(worse, worse)));
    }

    @Test
    void aPairOfWhichARunHasNoValueHasNoDifference() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0))
                .withDuration(30);
        ComparedRun following = ComparedRun.of(HeadlessRun.run(setup, ControllerMode.DIRECT, List.of()), List.of(), 1);
        assertFalse(Metric.COVERAGE.summary(List.of(following)).equals("none"));
        RunPair first = new RunPair(following, RESTING);
        RunPair second = new RunPair(RESTING, following);
        assertEquals("none", Metric.COVERAGE.difference(List.of(first, second)));
        assertEquals(
                "0.000 (n = 1)", Metric.COVERAGE.difference(List.of(first, second, new RunPair(following, following))));
    }

    @Test
    void aDistanceErrorIsGivenToATenthOfAMillimetre() {
        assertEquals("0.0123", Metric.DISTANCE_RMS.summary(new double[] {0.012345}, 1));
    }

    @Test
    void aDifferenceThatIsRoundedToZeroHasNoSign() {
        assertEquals("0.00 [0.00, 0.00]", Metric.PATH.summary(new double[] {-0.001, -0.001}, 2));
    }

    @Test
    void runsThatAreAllEqualCountOnce() {
        ControllerRuns.FailedRun broken = new ControllerRuns.FailedRun(3, "it broke");
        for (List<ControllerRuns.FailedRun> failed : List.of(List.<ControllerRuns.FailedRun>of(), List.of(broken))) {
            ControllerRuns resting = new ControllerRuns("rest", List.of(RESTING, RESTING), failed);
            assertTrue(resting.areAllEqual());
            assertEquals(List.of(RESTING), resting.countedRuns());
            assertEquals("0.00", Metric.COLLISION.summary(resting.countedRuns()));
        }
        ControllerRuns varying = new ControllerRuns("vary", List.of(RESTING, COLLIDING), List.of());
        assertEquals(varying.runs(), varying.countedRuns());
        ControllerRuns single = new ControllerRuns("one", List.of(RESTING), List.of());
        assertFalse(single.areAllEqual());
        assertEquals(single.runs(), single.countedRuns());
    }
}
