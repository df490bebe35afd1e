package faultline.gui.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** The ticks of a run at which something is marked on the time line, and what it is. */
final class EventStops {

    /** The stops of a run without marks. */
    static final EventStops NONE = new EventStops(List.of());

    private final NavigableMap<Long, List<Supplier<String>>> texts = new TreeMap<>();

    /** Something that is marked at a tick; the text is in the current language. */
    record Stop(long tick, Supplier<String> text) {}

    EventStops(List<Stop> stops) {
        stops.forEach(stop ->
                texts.computeIfAbsent(stop.tick(), tick -> new ArrayList<>()).add(stop.text()));
    }

    /** Returns the next tick with a mark after a tick, up to the last tick of the run. */
    OptionalLong after(long tick, long last) {
        Long next = texts.higherKey(tick);
        return optional(next == null || next > last ? null : next);
    }

    /** Returns the last tick with a mark before a tick. */
    OptionalLong before(long tick) {
        return optional(texts.lowerKey(tick));
    }

    private static OptionalLong optional(Long tick) {
        return tick == null ? OptionalLong.empty() : OptionalLong.of(tick);
    }

    /** Returns what is marked at a tick, empty for nothing. */
    String text(long tick) {
        return texts.getOrDefault(tick, List.of()).stream()
                .map(Supplier::get)
                .distinct()
                .collect(Collectors.joining("; "));
    }
}
