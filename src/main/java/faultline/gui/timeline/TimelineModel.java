package faultline.gui.timeline;

import faultline.engine.SimulationSetup.TimedCommand;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The commands of a scenario's timeline as items: a fault and the command that removes it are one item, and so are
 * switching a sensor off and on. Edits return new lists of commands, in which all other commands keep their order.
 */
public final class TimelineModel {

    /** The model of an empty timeline. */
    public static final TimelineModel EMPTY = of(List.of());

    private static final int NONE = -1;

    private final List<TimedCommand> commands;
    private final List<Pair> pairs = new ArrayList<>();
    private final List<TimelineItem> items;

    /**
     * An item and the indices of its commands.
     *
     * @param item the item
     * @param first the index of its first command
     * @param last the index of the command that ends it, or {@link #NONE}
     */
    private record Pair(TimelineItem item, int first, int last) {

        /** Returns whether a later command ends this interval. */
        boolean isEndedBy(TimedCommand later) {
            return last == NONE && item.endings().contains(later.command());
        }

        Pair endedBy(TimedCommand later, int index) {
            return new Pair(item.withTimes(item.start(), later.time()), first, index);
        }
    }

    private TimelineModel(List<TimedCommand> commands) {
        this.commands = List.copyOf(commands);
        IntStream.range(0, commands.size())
                .boxed()
                .sorted(Comparator.comparingDouble(index -> commands.get(index).time()))
                .forEachOrdered(this::add);
        pairs.sort(Comparator.comparingDouble(pair -> pair.item().start()));
        items = pairs.stream().map(Pair::item).toList();
    }

    /** Returns the model of a timeline. */
    public static TimelineModel of(List<TimedCommand> commands) {
        return new TimelineModel(commands);
    }

    private void add(int index) {
        TimedCommand timed = commands.get(index);
        boolean found = false;
        boolean endsOthers = true;
        for (int i = 0; i < pairs.size() && endsOthers; i++) {
            if (pairs.get(i).isEndedBy(timed)) {
                endsOthers = !pairs.get(i).item().endings().get(0).equals(timed.command());
                pairs.set(i, pairs.get(i).endedBy(timed, index));
                found = true;
            }
        }
        if (!found) {
            pairs.add(new Pair(TimelineItem.from(timed.command(), timed.time()), index, NONE));
        }
    }

    /** Returns the items in the order of their starts; always the same list. */
    public List<TimelineItem> items() {
        return items;
    }

    /** Returns the commands. */
    public List<TimedCommand> commands() {
        return commands;
    }

    /** Returns the commands with another item at the end. */
    List<TimedCommand> with(TimelineItem added) {
        List<TimedCommand> result = new ArrayList<>(commands);
        result.addAll(added.commands());
        return result;
    }

    /** Returns the commands without an item, given its index. */
    List<TimedCommand> without(int item) {
        return replaced(pairs.get(item), List.of());
    }

    /** Returns the commands with an item, given its index, replaced by another one. */
    List<TimedCommand> with(int item, TimelineItem changed) {
        return replaced(pairs.get(item), changed.commands());
    }

    private List<TimedCommand> replaced(Pair pair, List<TimedCommand> replacement) {
        List<TimedCommand> result = new ArrayList<>();
        for (int i = 0; i < commands.size(); i++) {
            if (i == pair.first()) {
                result.addAll(replacement);
            } else if (i == pair.last()) {
                result.addAll(endsOfOthers(pair));
            } else {
                result.add(commands.get(i));
            }
        }
        return result;
    }

    /** Returns commands that end the other items which the last command of a pair ends. */
    private List<TimedCommand> endsOfOthers(Pair pair) {
        return pairs.stream()
                .filter(other -> other != pair && other.last() == pair.last())
                .map(other -> other.item().commands().get(1))
                .toList();
    }
}
