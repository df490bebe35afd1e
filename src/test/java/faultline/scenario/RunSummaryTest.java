package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RunSummaryTest {

    @Test
    void everyLineHasTheValueOfItsKey() {
        assertEquals(
                List.of(
                        "ticks: 250",
                        "simulated_s: 2.5",
                        "real_time_factor: 12.3",
                        "state: FOLLOW",
                        "states: SEARCH FOLLOW",
                        "collision: 1.500000000,0.250000000 at 2.250000000",
                        "collided_with: pole",
                        "coverage: 0.7500",
                        "distance_rms_m: 0.003000",
                        "follow_rms_m: 0.004500",
                        "trajectory_hash: 00000000000000ff",
                        "seed: 7",
                        "rung: THREE",
                        "rung_changes: THREE at 0.75",
                        "health_changes: left OFF at 0.5, left trusted at 2"),
                RunSummary.lines(SampleResults.eventful()));
    }

    @Test
    void aStateWithABlankIsInQuotes() {
        Telemetry telemetry = Telemetry.ofState(ControllerState.of("wall ahead"));
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 4, true, 3, List.of()), new Pose(2, 2, 0))
                .withDuration(0.05);
        RunResult result =
                HeadlessRun.run(setup, observation -> new Decision(0, 0, telemetry), ControllerMode.DIRECT, List.of());
        List<String> lines = RunSummary.lines(result);
        assertTrue(lines.contains("states: SEARCH \"wall ahead\""), lines::toString);
        assertEquals(
                Optional.of("expected the state wall, but it was never reached; passed: SEARCH \"wall ahead\""),
                new Expectation.VisitedState(ControllerState.of("wall")).unmet(result));
    }

    @Test
    void aMissingValueIsNone() {
        List<String> missing = RunSummary.lines(SampleResults.uneventful()).stream()
                .filter(line -> line.endsWith(": none"))
                .map(line -> line.substring(0, line.indexOf(':')))
                .toList();
        assertEquals(
                List.of(
                        "real_time_factor",
                        "collision",
                        "collided_with",
                        "coverage",
                        "distance_rms_m",
                        "follow_rms_m",
                        "rung",
                        "rung_changes",
                        "health_changes"),
                missing);
    }

    @Test
    void numbersAreRoundedAsAFormatterRoundsThem() {
        SplittableRandom random = new SplittableRandom(905);
        for (int trial = 0; trial < 20_000; trial++) {
            double value = Math.pow(10, random.nextDouble(-9, 6));
            int digits = random.nextInt(1, 8);
            double half = Math.floor(value * 1000) / 1000 + 0.0005;
            assertEquals(
                    String.format(Locale.ROOT, "%." + digits + "f", value), RunSummary.formatNumber(value, digits));
            assertEquals(String.format(Locale.ROOT, "%.3f", half), RunSummary.formatNumber(half, 3));
        }
        assertEquals("0.0000", RunSummary.formatNumber(0, 4));
        assertEquals("none", RunSummary.formatNumber(Double.NaN, 4));
    }
}
