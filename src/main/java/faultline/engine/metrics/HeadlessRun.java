package faultline.engine.metrics;

import faultline.control.Controller;
import faultline.control.ControllerState;
import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.recording.DiagnosisRecorder;
import faultline.engine.recording.RunEvent;
import faultline.io.DecimalText;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/** Runs a setup to its end without a window. */
public final class HeadlessRun {

    private static final double NANOS_PER_SECOND = 1e9;

    private HeadlessRun() {}

    /**
     * {@return the result of a run to its duration, as fast as possible}
     *
     * @param setup the setup
     * @param mode the thread of the controller
     * @param observers called at tick 0 and after every tick, in order
     * @throws RunFailedException if the run failed
     */
    public static RunResult run(SimulationSetup setup, ControllerMode mode, List<TickObserver> observers) {
        return run(setup, mode, observers, () -> false);
    }

    /**
     * {@return the result of a run to its duration or until a condition holds, as fast as possible}
     *
     * @param setup the setup
     * @param mode the thread of the controller
     * @param observers called at tick 0 and after every tick, in order
     * @param finished called before every tick; true ends the run
     * @throws RunFailedException if the run failed
     */
    public static RunResult run(
            SimulationSetup setup, ControllerMode mode, List<TickObserver> observers, BooleanSupplier finished) {
        return run(
                setup,
                listener -> new Simulation(setup, mode, listener),
                observers,
                finished,
                new WallFollowingMetrics(setup));
    }

    /**
     * {@return the result of a run to its duration with a given controller instead of the setup's}
     *
     * @param setup the setup
     * @param controller drives the robot; not closed with the run
     * @param mode the thread of the controller
     * @param observers called at tick 0 and after every tick, in order
     * @throws RunFailedException if the run failed
     */
    public static RunResult run(
            SimulationSetup setup, Controller controller, ControllerMode mode, List<TickObserver> observers) {
        return run(
                setup,
                listener -> new Simulation(setup, controller, mode, listener),
                observers,
                () -> false,
                new WallFollowingMetrics(setup));
    }

    /** Runs a simulation that a function starts, with separate metrics. */
    static RunResult run(
            SimulationSetup setup,
            Function<CommandListener, Simulation> start,
            List<TickObserver> observers,
            BooleanSupplier finished,
            WallFollowingMetrics wall) {
        VisitedStates states = new VisitedStates();
        List<TickObserver> all = new ArrayList<>(observers);
        all.add(wall);
        List<RunEvent> diagnosis = new ArrayList<>();
        all.add(new DiagnosisRecorder(diagnosis::add));
        all.add(states);
        long began = System.nanoTime();
        List<String> refused = new ArrayList<>();
        CommandListener noting = result -> result.refusal()
                .ifPresent(refusal -> refused.add(
                        "at " + DecimalText.format(setup.timeOf(result.tick())) + " s: " + refusal.message()));
        try (Simulation simulation = start.apply(noting)) {
            long ticks = setup.ticks();
            all.forEach(observer -> observer.observe(simulation));
            while (simulation.ticks() < ticks && !finished.getAsBoolean()) {
                simulation.tick();
                for (TickObserver observer : all) {
                    observer.observe(simulation);
                }
            }
            double seconds = (System.nanoTime() - began) / NANOS_PER_SECOND;
            return result(simulation, wall, states, refused, diagnosis, seconds);
        }
    }

    /** Lists the states of the controller in the order of their first appearance. */
    private static final class VisitedStates implements TickObserver {
        private final Set<ControllerState> visited = new LinkedHashSet<>();
        private ControllerState last;

        @Override
        public void observe(Simulation simulation) {
            ControllerState state = simulation.telemetry().state();
            // Querying a set in every tick would be slow.
            if (state != last) {
                visited.add(state);
                last = state;
            }
        }
    }

    /** Thrown if a run has ended, but its result cannot be computed. */
    public static final class ResultFailedException extends RunFailedException {

        private static final long serialVersionUID = 1L;

        /**
         * Creates the exception for a coverage that cannot be computed.
         *
         * @param cause the cause
         */
        public ResultFailedException(Throwable cause) {
            super("its coverage could not be computed: " + cause, cause);
        }
    }

    private static double coverage(WallFollowingMetrics wall) {
        try {
            return wall.coverage().orElse(Double.NaN);
        } catch (RuntimeException | VirtualMachineError e) {
            throw new ResultFailedException(e);
        }
    }

    private static RunResult result(
            Simulation simulation,
            WallFollowingMetrics wall,
            VisitedStates states,
            List<String> refused,
            List<RunEvent> diagnosis,
            double seconds) {
        return new RunResult(
                simulation.ticks(),
                simulation.setup().timeOf(simulation.ticks()),
                simulation.time() / seconds,
                simulation.telemetry().state(),
                List.copyOf(states.visited),
                coverage(wall),
                wall.isPathTooLong(),
                wall.distanceRms().orElse(Double.NaN),
                wall.followRms().orElse(Double.NaN),
                simulation.trajectoryHash(),
                simulation.setup().seed(),
                refused,
                simulation.telemetry().diagnosis().rung(),
                diagnosis,
                simulation.snapshot());
    }
}
