package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.RobotPath;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.Snapshot;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class ControllerRunsTest {

    /** Returns the result of a run in which obstacles are removed that the yard does not have, at 0.5 s. */
    private static RunResult removing(String... obstacles) throws Exception {
        List<TimedCommand> timeline = Arrays.stream(obstacles)
                .map(obstacle -> new TimedCommand(0.5, new Command.RemoveObstacle(obstacle)))
                .toList();
        SimulationSetup setup =
                Scenario.load(Path.of("scenarios/yard.xml")).setup().withDuration(1);
        return HeadlessRun.run(setup.withTimeline(timeline), ControllerMode.DIRECT, List.of());
    }

    @Test
    void aRefusalInSomeOfTheRunsIsGivenOnceWithTheirNumber() throws Exception {
        List<ControllerRuns.ComparedRun> runs =
                List.of(removing("cat"), removing("cat", "dog", "dog"), removing("cat")).stream()
                        .map(result -> ControllerRuns.ComparedRun.of(result, List.of(), 0))
                        .toList();
        assertEquals(
                List.of(
                        "refused at 0.5 s: there is no obstacle cat",
                        "refused at 0.5 s: there is no obstacle dog (in 1 of 3 runs)"),
                new ControllerRuns("none", runs, List.of()).refusals());
    }

    private static ControllerRuns runsOfSeeds(String controller, long... seeds) throws Exception {
        SimulationSetup setup =
                Scenario.load(Path.of("scenarios/yard.xml")).setup().withDuration(0.1);
        List<ControllerRuns.ComparedRun> runs = Arrays.stream(seeds)
                .mapToObj(seed -> HeadlessRun.run(setup.withSeed(seed), ControllerMode.DIRECT, List.of()))
                .map(result -> ControllerRuns.ComparedRun.of(result, List.of(), 0))
                .toList();
        return new ControllerRuns(controller, runs, List.of());
    }

    @Test
    void runsWithTheSameSeedArePairs() throws Exception {
        ControllerRuns own = runsOfSeeds("own", 1, 2, 4, 5);
        ControllerRuns other = runsOfSeeds("other", 2, 3, 5);
        assertEquals(
                List.of("2 2", "5 5"),
                own.pairs(other).stream()
                        .map(pair -> pair.own().seed() + " " + pair.other().seed())
                        .toList());
    }

    @Test
    void pairsOfRunsThatAreAllEqualCountOnce() throws Exception {
        ControllerRuns own = runsOfSeeds("own", 1, 2);
        assertTrue(own.areAllEqual());
        assertEquals(1, own.countedPairs(runsOfSeeds("other", 1, 2)).size());
        assertEquals(List.of(), own.countedPairs(runsOfSeeds("other", 3, 4)));
        SimulationSetup longer =
                Scenario.load(Path.of("scenarios/yard.xml")).setup().withDuration(0.2);
        RunResult other = HeadlessRun.run(longer.withSeed(2), ControllerMode.DIRECT, List.of());
        ControllerRuns varied = new ControllerRuns(
                "varied", List.of(own.runs().get(0), ControllerRuns.ComparedRun.of(other, List.of(), 0.1)), List.of());
        assertEquals(2, own.countedPairs(varied).size());
        assertEquals(2, varied.countedPairs(own).size());
    }

    @Test
    void theRunsOfTheFirstHundredSeedsAreDrawn() throws Exception {
        SimulationSetup first = Scenario.load(Path.of("scenarios/yard.xml"))
                .setup()
                .withDuration(0.1)
                .withSeed(50);
        RobotPath path;
        try (Simulation run = new Simulation(first, ControllerMode.DIRECT)) {
            path = run.frame().path();
        }
        for (long seed : new long[] {50, 149, 150}) {
            RunResult result = HeadlessRun.run(first.withSeed(seed), ControllerMode.DIRECT, List.of());
            ControllerRuns.ComparedRun run = ControllerRuns.ComparedRun.of(result, path, 0, first);
            assertEquals(seed == 150, run.path().isEmpty(), "seed " + seed);
        }
    }

    /** A comparison may have 10 000 runs in a world with as many moving obstacles. */
    @Test
    void theWorldAtTheEndOfARunIsNotKept() throws Exception {
        RunResult result = removing("cat");
        WeakReference<Snapshot> end = new WeakReference<>(result.finalSnapshot());
        ControllerRuns.ComparedRun run = ControllerRuns.ComparedRun.of(result, List.of(), 0);
        result = null;
        for (int i = 0; i < 50 && end.get() != null; i++) {
            System.gc();
        }
        assertNull(end.get());
        assertEquals(1, run.refusals().size());
    }
}
