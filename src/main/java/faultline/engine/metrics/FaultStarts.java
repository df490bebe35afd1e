package faultline.engine.metrics;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Finds the faults of a timeline that begin, without those that a later command of the same tick ends. */
final class FaultStarts {

    private final List<TimedCommand> commands;
    private final long[] ticks;
    /** The commands that begin a fault, by their indices. */
    private final BitSet begun = new BitSet();
    /**
     * The indices of the commands that began the active faults, oldest first, by the sensor or the side of the motors
     * and the fault.
     */
    private final Map<Object, Map<Object, Deque<Integer>>> active = new HashMap<>();

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
            endOldest(index, repair.sensor(), repair.fault());
        } else if (command instanceof Command.ClearMotorFault repair) {
            endOldest(index, repair.motor(), repair.fault());
        } else if (command instanceof Command.ClearFaults repair) {
            endAll(index, repair.sensor());
        } else if (command instanceof Command.ClearMotorFaults repair) {
            endAll(index, repair.motor());
        }
    }

    private void begin(int index, Object part, Object fault) {
        begun.set(index);
        active.computeIfAbsent(part, other -> new HashMap<>())
                .computeIfAbsent(fault, other -> new ArrayDeque<>())
                .add(index);
    }

    private void endOldest(int index, Object part, Object fault) {
        Deque<Integer> equal = active.getOrDefault(part, Map.of()).getOrDefault(fault, new ArrayDeque<>());
        if (!equal.isEmpty()) {
            end(index, equal.remove());
        }
    }

    private void endAll(int index, Object part) {
        Map<Object, Deque<Integer>> ended = active.remove(part);
        if (ended != null) {
            ended.values().forEach(equal -> equal.forEach(start -> end(index, start)));
        }
    }

    /** A fault that ends in the tick in which it begins never acts. */
    private void end(int index, int start) {
        if (ticks[start] == ticks[index]) {
            begun.clear(start);
        }
    }
}
