package faultline.engine.metrics;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.World;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * Finds what a run is like when its first tick moves the robot. The commands for time 0 and those of the first tick,
 * such as what a user edits before the run, are then part of the start by which the run is measured.
 */
final class FirstTick {

    private FirstTick() {}

    /** Returns a setup with the world, the robot and the controller of its first tick. */
    static SimulationSetup setup(SimulationSetup setup) {
        return setup(setup, List.of());
    }

    /**
     * Returns a setup with the world, the robot and the controller of its first tick, and without the commands of the
     * timeline that make them; the setup itself if there are none.
     *
     * @param setup the setup of the run
     * @param outside the commands from outside that are executed in the first tick, after those of the timeline
     */
    static SimulationSetup setup(SimulationSetup setup, List<Command> outside) {
        List<TimedCommand> planned = setup.timeline().stream()
                .filter(timed ->
                        setup.tickAt(timed.time()) <= 1 && timed.command().changesSetup())
                .sorted(Comparator.comparingLong(timed -> setup.tickAt(timed.time())))
                .toList();
        List<Command> commands = Stream.concat(planned.stream().map(TimedCommand::command), outside.stream())
                .filter(Command::changesSetup)
                .toList();
        if (commands.isEmpty()) {
            return setup;
        }
        List<TimedCommand> later = setup.timeline().stream()
                .filter(timed ->
                        setup.tickAt(timed.time()) > 1 || !timed.command().changesSetup())
                .toList();
        return configured(edited(setup, commands), commands).withTimeline(later);
    }

    private static SimulationSetup edited(SimulationSetup setup, List<Command> commands) {
        if (commands.stream().allMatch(command -> command instanceof Command.ConfigureController)) {
            // A world takes long to make if there are many walls.
            return setup;
        }
        World world = new World(setup.world(), setup.robot(), setup.start(), setup.dt(), setup.seed());
        commands.forEach(world::execute);
        SimulationSetup edited = setup.withRobot(world.robot());
        return world.obstacles().equals(setup.world().obstacles())
                ? edited
                : edited.withWorld(setup.world().withObstacles(world.obstacles()));
    }

    private static SimulationSetup configured(SimulationSetup setup, List<Command> commands) {
        SimulationSetup configured = setup;
        if (setup.controller() instanceof ControllerSpec.BuiltIn) {
            for (Command command : commands) {
                if (command instanceof Command.ConfigureController change) {
                    configured = configured.withController(change.controller());
                }
            }
        }
        return configured;
    }
}
