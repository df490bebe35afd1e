package faultline.gui.timeline;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.sensor.OldestFirst;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The commands of a scenario's timeline as items: a fault and the command that removes it are one item, and so are
 * switching a sensor off and on. Edits return new lists of commands, in which all other commands keep their order.
 */
public final class TimelineModel {

    /** The model of an empty timeline. */
    public static final TimelineModel EMPTY = of(List.of(), 1);

    private static final int NONE = -1;

    private final List<TimedCommand> commands;
    private final double dt;
    private final List<PairedCommands> pairs = new ArrayList<>();
    private final List<TimelineItem> items;
    /** An item, the index of its first command, and that of the command that ends it, or {@link #NONE}. */
    private record PairedCommands(TimelineItem item, int first, int last) {

        PairedCommands endedBy(TimedCommand later, int index) {
            // Within a tick, the times need not be in order.
            return new PairedCommands(item.withTimes(item.start(), Math.max(item.start(), later.time())), first, index);
        }
    }

    private TimelineModel(List<TimedCommand> commands, double dt) {
        this.commands = List.copyOf(commands);
        this.dt = dt;
        OldestFirst<Command, Integer> open = new OldestFirst<>();
        IntStream.range(0, commands.size())
                .boxed()
                .sorted(Comparator.comparingLong(
                        index -> tickAt(commands.get(index).time())))
                .forEachOrdered(index -> add(index, open));
        items = pairs.stream().map(PairedCommands::item).toList();
    }

    /** Returns the model of a timeline of a run with ticks of a length, seconds, in whose order it is executed. */
    public static TimelineModel of(List<TimedCommand> commands, double dt) {
        return new TimelineModel(commands, dt);
    }

    /** Returns whether this is the model of a timeline of a run with ticks of a length. */
    boolean isOf(List<TimedCommand> others, double length) {
        return dt == length && commands.equals(others);
    }

    private long tickAt(double time) {
        return SimulationSetup.tickAt(time, dt);
    }

    /** Adds a command; {@code open} has the intervals by the commands that would end them, some ended since. */
    private void add(int index, OldestFirst<Command, Integer> open) {
        TimedCommand timed = commands.get(index);
        boolean found = false;
        Optional<Integer> oldest = open.end(timed.command());
        while (oldest.isPresent()) {
            PairedCommands pair = pairs.get(oldest.get());
            boolean endsOthers = true;
            if (pair.last() == NONE) {
                pairs.set(oldest.get(), pair.endedBy(timed, index));
                endsOthers = pair.item().isEndedWithOthers(timed.command());
                found = true;
            }
            oldest = endsOthers ? open.end(timed.command()) : Optional.empty();
        }
        if (!found) {
            PairedCommands pair = new PairedCommands(TimelineItem.from(timed.command(), timed.time()), index, NONE);
            pair.item().endings().forEach(ending -> open.begin(ending, pairs.size()));
            pairs.add(pair);
        }
    }

    /** Returns the items in the order of their starts; always the same list. */
    public List<TimelineItem> items() {
        return items;
    }

    public List<TimedCommand> commands() {
        return commands;
    }

    /** Returns the commands with another item at the end. */
    List<TimedCommand> with(TimelineItem added) {
        List<TimedCommand> result = replaced(commands.size(), NONE, List.of(added));
        result.addAll(added.commands());
        return result;
    }

    /** Returns the commands without an item, given its index. */
    List<TimedCommand> without(int item) {
        PairedCommands pair = pairs.get(item);
        return replaced(pair.first(), pair.last(), List.of());
    }

    /** Returns the commands with an item, given its index, replaced by another one. */
    List<TimedCommand> with(int item, TimelineItem changed) {
        PairedCommands pair = pairs.get(item);
        return replaced(pair.first(), pair.last(), List.of(changed));
    }

    /** Returns the commands with those of an item, given their indices, replaced by those of another one, or none. */
    private List<TimedCommand> replaced(int first, int last, List<TimelineItem> replacement) {
        List<TimedCommand> result = new ArrayList<>();
        for (int i = 0; i < commands.size(); i++) {
            int index = i;
            Predicate<TimedCommand> cutsShort =
                    end -> replacement.stream().anyMatch(item -> cutsShort(end, index > first, item));
            if (i == first) {
                replacement.forEach(item -> result.addAll(item.commands()));
            } else if (i == last || cutsShort.test(commands.get(i)) && isEnd(i)) {
                endsOfOthers(i, first).filter(cutsShort.negate()).forEach(result::add);
            } else {
                result.add(commands.get(i));
            }
        }
        return result;
    }

    /** Returns whether the end of other items would also end an item, which it follows in the file or not. */
    private boolean cutsShort(TimedCommand end, boolean follows, TimelineItem item) {
        long from = tickAt(item.start());
        boolean begun = tickAt(end.time()) > from || follows && tickAt(end.time()) == from;
        return begun && end.time() <= item.end() && item.isEndedWithOthers(end.command());
    }

    private boolean isEnd(int index) {
        return pairs.stream().anyMatch(pair -> pair.last() == index);
    }

    /** Returns commands that end the items which a command ends, except the item that begins at {@code first}. */
    private Stream<TimedCommand> endsOfOthers(int index, int first) {
        // One command switches a sensor on, but each fault has its own removal.
        boolean single = commands.get(index).command() instanceof Command.SwitchSensor;
        return pairs.stream()
                .filter(pair -> pair.first() != first && pair.last() == index)
                .map(pair -> pair.item().commands().get(1))
                .limit(single ? 1 : pairs.size());
    }
}
