package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.walls.Coverage;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A run without a window: its observers, and its result. */
class HeadlessRunTest {

    private static SimulationSetup setup(SimulationSetup.TimedCommand... timeline) {
        WorldSpec world = new WorldSpec(4, 3, true, 3, List.of());
        return SimulationSetup.of(world, new Pose(2, 1.5, 0))
                .withController(new ControllerSpec.None())
                .withTimeline(List.of(timeline))
                .withTick(0.25)
                .withSeed(7)
                .withDuration(1);
    }

    @Test
    void observersSeeTickZeroAndEveryTickAfterIt() {
        List<Long> ticks = new ArrayList<>();
        RunResult result =
                HeadlessRun.run(setup(), ControllerMode.DIRECT, List.of(simulation -> ticks.add(simulation.ticks())));
        assertEquals(List.of(0L, 1L, 2L, 3L, 4L), ticks);
        assertEquals(4, result.ticks());
        assertEquals(1, result.simulatedSeconds());
        assertEquals(7, result.seed());
    }

    @Test
    void refusedTimelineCommandsAreReported() {
        SimulationSetup.TimedCommand impossible =
                new SimulationSetup.TimedCommand(0.5, new Command.ClearFault("left", new Fault.Dead()));
        RunResult result = HeadlessRun.run(setup(impossible), ControllerMode.DIRECT, List.of());
        assertEquals(List.of("at 0.5 s: left has no such fault"), result.refusals());
    }

    @Test
    void aControllerThatFollowsNoWallHasNeitherCoverageNorDistanceError() {
        RunResult result = HeadlessRun.run(setup(), ControllerMode.DIRECT, List.of());
        assertTrue(result.coverage().isEmpty());
        assertTrue(result.distanceRms().isEmpty());
    }

    @Test
    void aRunAlongAPathOfTooManyPlacesHasAllOtherResults() {
        SimulationSetup setup = setup().withController(ControllerSpec.WallFollowing.DEFAULT)
                .withTick(0.01)
                .withDuration(20);
        RunResult result = HeadlessRun.run(
                setup,
                listener -> new Simulation(setup, ControllerMode.DIRECT, listener),
                List.of(),
                () -> false,
                new WallFollowingMetrics(setup, (walls, distance) -> new Coverage(walls, distance, 100)));
        assertTrue(result.isPathTooLong());
        assertTrue(result.coverage().isEmpty());
        assertTrue(result.followRms().isPresent());
        Expectation expectation = new Expectation(List.of(new Expectation.MinCoverage(0.5)));
        assertEquals(List.of("expected a coverage of at least 0.5, but it is not known"), expectation.unmet(result));
    }

    @Test
    void aCoverageThatCannotBeComputedFailsTheRunAfterItsEnd() {
        List<Long> ticks = new ArrayList<>();
        SimulationSetup setup = setup().withController(ControllerSpec.WallFollowing.DEFAULT)
                .withTick(0.01)
                .withDuration(20);
        HeadlessRun.ResultFailedException failure = assertThrows(
                HeadlessRun.ResultFailedException.class,
                // Without walls there is no coverage.
                () -> HeadlessRun.run(
                        setup,
                        listener -> new Simulation(setup, ControllerMode.DIRECT, listener),
                        List.of(simulation -> ticks.add(simulation.ticks())),
                        () -> false,
                        new WallFollowingMetrics(setup, (walls, distance) -> new Coverage(null, distance))));
        assertTrue(failure.getMessage().startsWith("its coverage could not be computed: "), failure.getMessage());
        assertEquals(2000, ticks.get(ticks.size() - 1));
    }
}
