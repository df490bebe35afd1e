package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.control.wallfollower.Observations;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class StateTrackerTest {

    private final Deque<Telemetry> given = new ArrayDeque<>();
    private final StateTracker tracker = new StateTracker(observation -> new Decision(1, 2, given.remove()), "");

    private static Telemetry state(String name) {
        return Telemetry.ofState(ControllerState.of(name));
    }

    private Decision decide(long tick, Telemetry telemetry) {
        given.add(telemetry);
        return tracker.decide(Observations.observation(tick, Map.of()));
    }

    @Test
    void itCountsTheChangesOfAControllerThatOnlyNamesItsStates() {
        List<String> names = List.of("A", "A", "B", "B", "A");
        List<Integer> transitions = List.of(0, 0, 1, 1, 2);
        List<Long> since = List.of(0L, 0L, 12L, 12L, 14L);
        for (int i = 0; i < names.size(); i++) {
            Decision decision = decide(10 + i, state(names.get(i)));
            Telemetry telemetry = decision.telemetry();
            assertEquals(ControllerState.of(names.get(i)), telemetry.state());
            assertEquals(transitions.get(i), telemetry.transitions());
            assertEquals(since.get(i), telemetry.sinceTick());
            assertEquals(1, decision.leftVolts());
            assertEquals(2, decision.rightVolts());
        }
    }

    @Test
    void aControllerThatCountsByItselfIsBelieved() {
        decide(1, state("A"));
        Telemetry counted = state("A").entering("B", "seen", 2);
        assertEquals(1, counted.transitions());
        assertSame(counted, decide(2, counted).telemetry());
    }

    @Test
    void whatElseIsShownIsThatOfTheLastDecision() {
        decide(1, state("A"));
        Telemetry.WallControl wall = new Telemetry.WallControl(0.25, 0.3, 1, 2);
        Telemetry.EdgeTimes edges = new Telemetry.EdgeTimes(1, 2, 0.5);
        Telemetry telemetry = decide(
                        2, new Telemetry(ControllerState.of("B"), "why", 0, 0, wall, edges, Telemetry.Diagnosis.NONE))
                .telemetry();
        assertEquals(wall, telemetry.wall());
        assertEquals(edges, telemetry.edges());
        assertEquals("why", telemetry.condition());
        assertEquals(1, telemetry.transitions());
    }

    private static Telemetry counted(String state, String why, String rung) {
        Telemetry.Diagnosis diagnosis = new Telemetry.Diagnosis(rung, List.of());
        Telemetry plain = state(state);
        return new Telemetry(plain.state(), why, 3, 7, plain.wall(), plain.edges(), diagnosis);
    }

    @Test
    void longTextsAreCutOff() {
        String start = "x".repeat(200);
        decide(1, state(start + "first"));
        assertEquals(0, decide(2, state(start + "second")).telemetry().transitions());
        Telemetry expected = counted(start, start, start);
        assertEquals(expected, decide(3, expected).telemetry());
        assertEquals(expected, decide(4, counted(start + "y", start, start)).telemetry());
        assertEquals(expected, decide(5, counted(start, start + "y", start)).telemetry());
        assertEquals(expected, decide(6, counted(start, start, start + "y")).telemetry());
    }

    @Test
    void itHasTheNameThatItIsGiven() {
        assertEquals("mine", new StateTracker(observation -> null, "mine").name());
    }

    @Test
    void itClosesAControllerThatCanBeClosed() throws Exception {
        AtomicInteger closed = new AtomicInteger();
        class Closeable implements Controller, AutoCloseable {

            @Override
            public Decision decide(Observation observation) {
                return null;
            }

            @Override
            public void close() {
                closed.incrementAndGet();
            }
        }
        new StateTracker(new Closeable(), "").close();
        assertEquals(1, closed.get());
        new StateTracker(observation -> null, "").close();
    }
}
