package faultline.campaign.plan;

import java.util.HashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds names of rooms that two sources of worlds have in common. Takes time that is almost linear in the sources. */
final class RoomNames {

    private static final Pattern NAME = Pattern.compile("room-(0|[1-9]\\d{0,17})(.*)");

    /**
     * For each end of names: the ranges of numbers that are taken, disjoint, the first of each and the one after it.
     */
    private final Map<String, NavigableMap<Long, Long>> taken = new HashMap<>();

    /**
     * Adds the names of a source.
     *
     * @return a name of the source that was added before
     */
    Optional<String> add(WorldSource source) {
        if (source instanceof WorldSource.Rooms rooms) {
            return add(rooms.suffix(), rooms.first(), rooms.count());
        }
        Matcher name = NAME.matcher(source.label(0));
        return name.matches() ? add(name.group(2), Long.parseLong(name.group(1)), 1) : Optional.empty();
    }

    private Optional<String> add(String suffix, long first, int count) {
        NavigableMap<Long, Long> ranges = taken.computeIfAbsent(suffix, unseen -> new TreeMap<>());
        long start = first;
        long end = first + count;
        Optional<String> common = Optional.empty();
        for (Map.Entry<Long, Long> before = ranges.lowerEntry(end);
                before != null && before.getValue() > start;
                before = ranges.lowerEntry(end)) {
            ranges.remove(before.getKey());
            common = Optional.of(WorldSource.Rooms.label(Math.max(first, before.getKey()), suffix));
            start = Math.min(start, before.getKey());
            end = Math.max(end, before.getValue());
        }
        ranges.put(start, end);
        return common;
    }
}
