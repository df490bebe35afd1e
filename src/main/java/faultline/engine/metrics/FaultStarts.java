package faultline.engine.metrics;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.sensor.OldestFirst;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Finds the faults of a timeline that begin, without those that a later command of the same tick ends. */
final class FaultStarts {

    private final List<TimedCommand> commands;
    private final long[] ticks;
    /** The commands that begin a fault, by their indices. */
    private final BitSet begun = new BitSet();
    /** The active faults with the indices of the commands that began them, by the sensor or the side of the motors. */
    private final Map<Object, OldestFirst<Object, Integer>> active = new HashMap<>();

    private FaultStarts(SimulationSetup setup) {
        commands = new ArrayList<>(setup.timeline());
        commands.sort(Comparator.comparingLong(timed -> setup.tickAt(timed.time())));
        ticks = commands.stream().mapToLong(timed -> setup.tickAt(timed.time())).toArray();
    }

    /** Returns the commands that begin the faults, in the order of their execution. */
    static List<TimedCommand> of(SimulationSetup setup) {
        FaultStarts starts = new FaultStarts(setup);
        for (int i = 0; i < starts.ticks.length; i++) {
            starts.execute(i, starts.commands.get(i).command());
        }
        return starts.begun.stream().mapToObj(starts.commands::get).toList();
    }

    private void execute(int index, Command command) {
        if (command instanceof Command.InjectFault start) {
            begin(index, start.sensor(), start.fault());
        } else if (command instanceof Command.InjectMotorFault start) {
            begin(index, start.motor(), start.fault());
        } else if (command instanceof Command.ClearFault repair) {
            end(index, activeOf(repair.sensor()).end(repair.fault()).stream());
        } else if (command instanceof Command.ClearMotorFault repair) {
            end(index, activeOf(repair.motor()).end(repair.fault()).stream());
        } else if (command instanceof Command.ClearFaults repair) {
            end(index, activeOf(repair.sensor()).endAll().stream());
        } else if (command instanceof Command.ClearMotorFaults repair) {
            end(index, activeOf(repair.motor()).endAll().stream());
        }
    }

    private OldestFirst<Object, Integer> activeOf(Object part) {
        return active.computeIfAbsent(part, other -> new OldestFirst<>());
    }

    private void begin(int index, Object part, Object fault) {
        begun.set(index);
        activeOf(part).begin(fault, index);
    }

    /** A fault that ends in the tick in which it begins never acts. */
    private void end(int index, Stream<Integer> starts) {
        starts.filter(start -> ticks[start] == ticks[index]).forEach(begun::clear);
    }
}
