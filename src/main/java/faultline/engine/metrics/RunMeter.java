package faultline.engine.metrics;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.walls.WallCircuit;
import faultline.engine.walls.WallReference;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Measures a run while it is in progress. At the end, the coverage and the errors of the distance equal those of a run
 * without a window.
 */
public final class RunMeter implements TickObserver {

    /** The setup of the first tick. */
    private SimulationSetup setup;

    private WallFollowingMetrics wall;
    /** Null until the robot reaches a wall, because finding the paths along walls takes long in large worlds. */
    private CarryOnMetrics laps;
    /** Null until tick 0 is observed. */
    private StartState start;
    /** Whether the run is at the end of its duration. */
    private boolean atEnd;

    /** What is measured of tick 0. */
    private record StartState(
            ControllerSpec controller, RobotSpec robot, Vector2 centre, ControllerState state, boolean contact) {}

    /**
     * Creates a meter of one run of a setup.
     *
     * @param setup the setup of the run
     */
    public RunMeter(SimulationSetup setup) {
        start(FirstTick.setup(setup));
    }

    private void start(SimulationSetup firstTick) {
        setup = firstTick;
        wall = new WallFollowingMetrics(firstTick);
        laps = null;
    }

    @Override
    public void observe(Simulation simulation) {
        if (simulation.ticks() == 0) {
            start = new StartState(
                    simulation.controllerSpec(),
                    simulation.robot(),
                    simulation.pose().position(),
                    simulation.telemetry().state(),
                    simulation.collision().isPresent());
        } else if (simulation.ticks() == 1) {
            startWithEdits(simulation.journal());
        }
        wall.observe(simulation);
        atEnd = simulation.ticks() == setup.ticks();
        measureLaps(
                simulation.time(),
                simulation.pose().position(),
                simulation.telemetry().state(),
                simulation.collision().isPresent());
    }

    private void measureLaps(double now, Vector2 centre, ControllerState state, boolean contact) {
        if (laps == null && wall.hasBegun() && CarryOnMetrics.isAtWall(setup, state) && !wall.isLarge()) {
            laps = new CarryOnMetrics(circuit(), setup.robot().speed(), wall.startTime());
        }
        if (laps != null) {
            // The circuit is that of the first wanted distance.
            laps.update(now, wall.atStartDistance(centre), state, contact);
        }
    }

    /** Starts again, with tick 0, if commands from outside have changed what the run starts with. */
    @SuppressWarnings("ReferenceEquality") // The same object if they have not.
    private void startWithEdits(Journal journal) {
        List<Command> commands = journal.entries().stream()
                .filter(entry -> entry.tick() <= 1)
                .map(Journal.Entry::command)
                .toList();
        SimulationSetup edited = FirstTick.setup(setup, commands);
        if (edited != setup) {
            start(edited);
            if (start != null) {
                measureStart();
            }
        }
    }

    private void measureStart() {
        if (!start.contact) {
            wall.measureStart(start.controller, start.robot, start.centre, start.state);
        }
        measureLaps(0, start.centre, start.state, start.contact);
    }

    /** Returns the path that the robot follows; if it is too long, no laps are measured. */
    private WallCircuit circuit() {
        try {
            return CarryOnMetrics.circuit(setup.world(), wall.startDistance(), setup.robot());
        } catch (WallReference.PathTooLongException e) {
            return WallCircuit.empty();
        }
    }

    /** {@return the measures so far; in a world with many or long walls, the coverage is known at the end only} */
    public RunMeasures measures() {
        OptionalDouble coverage = atEnd ? wall.coverage() : wall.liveCoverage();
        return new RunMeasures(
                coverage.orElse(Double.NaN),
                wall.isPathTooLong(),
                wall.distanceRms().orElse(Double.NaN),
                wall.followRms().orElse(Double.NaN),
                laps == null ? Double.NaN : laps.laps().orElse(Double.NaN));
    }
}
