package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.scenario.Scenario;
import faultline.world.Command;
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
                        .map(result -> new ControllerRuns.ComparedRun(result, List.of(), 0))
                        .toList();
        assertEquals(
                List.of(
                        "refused at 0.5 s: there is no obstacle cat",
                        "refused at 0.5 s: there is no obstacle dog (in 1 of 3 runs)"),
                new ControllerRuns("none", runs, List.of()).refusals());
    }
}
