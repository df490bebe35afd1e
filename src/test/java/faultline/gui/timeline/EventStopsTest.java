package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalLong;
import java.util.Random;
import java.util.function.LongPredicate;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class EventStopsTest {

    private static EventStops.Stop stop(long tick, String text) {
        return new EventStops.Stop(tick, () -> text);
    }

    @Test
    void theNextAndThePreviousOneAreThoseOfAScanOfAllTicks() {
        Random random = new Random(11);
        for (int trial = 0; trial < 300; trial++) {
            long last = random.nextInt(60);
            List<EventStops.Stop> all = IntStream.range(0, random.nextInt(12))
                    .mapToObj(i -> stop(random.nextInt(80), "event " + i))
                    .toList();
            EventStops stops = new EventStops(all);
            LongPredicate marked = tick -> all.stream().anyMatch(one -> one.tick() == tick);
            for (long tick = 0; tick <= last; tick++) {
                OptionalLong next =
                        LongStream.rangeClosed(tick + 1, last).filter(marked).findFirst();
                OptionalLong previous = LongStream.range(0, tick).filter(marked).max();
                assertEquals(next, stops.after(tick, last), all + " after " + tick);
                assertEquals(previous, stops.before(tick), all + " before " + tick);
            }
        }
    }

    @Test
    void nothingIsMarkedInAnEmptyRun() {
        assertEquals(OptionalLong.empty(), EventStops.NONE.after(0, 100));
        assertEquals(OptionalLong.empty(), EventStops.NONE.before(100));
        assertEquals("", EventStops.NONE.text(3));
    }

    @Test
    void eventsOfOneTickAreOneStopThatNamesEachOnce() {
        EventStops stops = new EventStops(List.of(stop(7, "a"), stop(7, "b"), stop(7, "a"), stop(9, "c")));
        assertEquals("a; b", stops.text(7));
        assertEquals(OptionalLong.of(9), stops.after(7, 9));
        assertEquals(OptionalLong.empty(), stops.after(7, 8), "the run does not get there");
    }
}
