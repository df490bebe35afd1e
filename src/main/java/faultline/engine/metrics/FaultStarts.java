package faultline.engine.metrics;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Finds the faults of a timeline that begin, without those that a later command of the same tick ends. */
final class FaultStarts {

    /** How often each repair or switch follows the present command in its tick and has ended no other fault. */
    private final Map<Command, Integer> repairs = new HashMap<>();

    private FaultStarts() {}

    /** Returns the commands that begin the faults, in the order of their execution. */
    static List<TimedCommand> of(SimulationSetup setup) {
        List<TimedCommand> commands = new ArrayList<>(setup.timeline());
        commands.sort(Comparator.comparingLong(timed -> setup.tickAt(timed.time())));
        Collections.reverse(commands);
        FaultStarts starts = new FaultStarts();
        List<TimedCommand> begun = new ArrayList<>();
        long tick = -1;
        for (TimedCommand timed : commands) {
            if (setup.tickAt(timed.time()) != tick) {
                tick = setup.tickAt(timed.time());
                starts.repairs.clear();
            }
            if (starts.begins(timed.command())) {
                begun.add(timed);
            }
        }
        Collections.reverse(begun);
        return begun;
    }

    private boolean begins(Command command) {
        if (command instanceof Command.InjectFault start) {
            return !ends(
                    new Command.ClearFaults(start.sensor()), new Command.ClearFault(start.sensor(), start.fault()));
        }
        if (command instanceof Command.InjectMotorFault start) {
            return !ends(
                    new Command.ClearMotorFaults(start.motor()),
                    new Command.ClearMotorFault(start.motor(), start.fault()));
        }
        if (!command.changesSetup()) {
            repairs.merge(command, 1, Integer::sum);
        }
        return false;
    }

    /** Returns whether a fault is ended by a repair of all faults, or by one of its own, which ends no other. */
    private boolean ends(Command repairOfAll, Command repair) {
        if (repairs.containsKey(repairOfAll)) {
            return true;
        }
        int left = repairs.getOrDefault(repair, 0);
        if (left > 0) {
            repairs.put(repair, left - 1);
        }
        return left > 0;
    }
}
