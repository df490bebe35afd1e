package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.GainRule;
import faultline.control.Threshold;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.geometry.Pose;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Changes of the controller's settings during a run, in an empty room of 4.4 m by 3.1 m. */
class ConfigureControllerTest {

    private static final WallFollowing INITIAL = WallFollowing.DEFAULT;
    private static final SimulationSetup SETUP = SimulationSetup.of(
                    new WorldSpec(4.4, 3.1, true, 3, List.of()), new Pose(2.1, 1.4, 0.3))
            .withController(INITIAL)
            .withSeed(77)
            .withDuration(60);
    private static final long CHANGE = 2500;
    private static final long END = 5500;

    private static Simulation runWith(ControllerSpec.BuiltIn change, ControllerMode mode) {
        Simulation simulation = new Simulation(SETUP, mode);
        advanceTo(simulation, CHANGE);
        simulation.execute(new Command.ConfigureController(change));
        advanceTo(simulation, END);
        return simulation;
    }

    private static void advanceTo(Simulation simulation, long tick) {
        while (simulation.ticks() < tick) {
            simulation.tick();
        }
    }

    private static long hashWith(ControllerSpec.BuiltIn change, ControllerMode mode) {
        try (Simulation simulation = runWith(change, mode)) {
            return simulation.trajectoryHash();
        }
    }

    private static long unchangedHash() {
        try (Simulation simulation = new Simulation(SETUP, ControllerMode.DIRECT)) {
            advanceTo(simulation, END);
            return simulation.trajectoryHash();
        }
    }

    @Test
    void theSameSettingsChangeNothing() {
        assertEquals(unchangedHash(), hashWith(INITIAL, ControllerMode.DIRECT));
    }

    @Test
    void everyChangeGivesTheSameRunOnBothThreads() {
        for (ControllerSpec.BuiltIn change : List.of(
                INITIAL.withDistance(0.4),
                INITIAL.withSide(WallSide.RIGHT),
                INITIAL.withGainRule(new GainRule.Length(0.3)),
                INITIAL.withGainRule(new GainRule.Fixed(9, 5)),
                INITIAL.withDiagnosis(false),
                INITIAL.withPeriod(0.05),
                INITIAL.withThreshold(Threshold.AHEAD_MARGIN, 0.12),
                new ControllerSpec.Drive(1, 1.2),
                new ControllerSpec.None())) {
            assertEquals(
                    hashWith(change, ControllerMode.DIRECT),
                    hashWith(change, ControllerMode.OWN_THREAD),
                    change.toString());
        }
        assertNotEquals(unchangedHash(), hashWith(INITIAL.withDistance(0.4), ControllerMode.DIRECT));
        assertNotEquals(
                unchangedHash(), hashWith(INITIAL.withGainRule(new GainRule.Length(0.3)), ControllerMode.DIRECT));
    }

    @Test
    void theFollowerGoesOnAtTheNewDistanceFromItsState() {
        try (Simulation simulation = new Simulation(SETUP, ControllerMode.DIRECT)) {
            while (simulation.telemetry().state() != FollowerState.FOLLOW) {
                simulation.tick();
            }
            int transitions = simulation.telemetry().transitions();
            simulation.execute(new Command.ConfigureController(INITIAL.withDistance(0.28)));
            advanceTo(simulation, simulation.ticks() + 120);
            assertEquals(transitions, simulation.telemetry().transitions(), "along the same wall");
            assertEquals(0.28, simulation.telemetry().wall().measuredDistance(), 0.005);
            assertEquals(0.28, simulation.telemetry().wall().wantedDistance());
        }
    }

    @Test
    void anotherHandStartsANewSearch() {
        try (Simulation simulation = runWith(INITIAL.withSide(WallSide.RIGHT), ControllerMode.DIRECT)) {
            assertEquals(INITIAL.withSide(WallSide.RIGHT), simulation.controllerSpec());
            assertTrue(simulation.collision().isEmpty());
        }
    }

    @Test
    void noneStopsTheRobot() {
        try (Simulation simulation = runWith(new ControllerSpec.None(), ControllerMode.DIRECT)) {
            assertEquals("NONE", simulation.telemetry().state().name());
            assertEquals(0, simulation.velocity().linear(), 1e-6);
        }
    }

    @Test
    void theInverseRestoresTheSettings() {
        try (Simulation simulation = new Simulation(SETUP, ControllerMode.DIRECT)) {
            CommandResult result =
                    simulation.execute(new Command.ConfigureController(INITIAL.withTimingRule(TimingRule.RANGE)));
            assertEquals(List.of(new Command.ConfigureController(INITIAL)), result.inverse());
            assertEquals(1, simulation.journal().entries().size());
        }
    }

    /** A command of the timeline and one from outside at the same tick have the same effect. */
    @Test
    void theTimelineDoesTheSameAsACommandFromOutside() {
        ControllerSpec.BuiltIn change = INITIAL.withDistance(0.4);
        SimulationSetup timed = SETUP.withTimeline(List.of(
                new SimulationSetup.TimedCommand(SETUP.timeOf(CHANGE + 1), new Command.ConfigureController(change))));
        try (Simulation simulation = new Simulation(timed, ControllerMode.DIRECT)) {
            advanceTo(simulation, END);
            assertEquals(hashWith(change, ControllerMode.DIRECT), simulation.trajectoryHash());
        }
    }
}
