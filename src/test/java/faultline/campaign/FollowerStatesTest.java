package faultline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.SurvivalTrial.Conditions;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.control.WallSide;
import faultline.control.wallfollower.StateDiagram;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Tests the six states in random rooms: each is left in time, and none is entered too often. The system property
 * {@code faultline.rooms} sets the number of rooms, {@code faultline.rooms.seed} the first of them.
 */
class FollowerStatesTest {

    private static final int ROOMS = Integer.getInteger("faultline.rooms", 10);
    private static final long FIRST = Long.getLong("faultline.rooms.seed", 640_000);
    private static final double SECONDS = 90;

    /** No state is entered more than ten times in ten seconds. */
    private static final int MAX_ENTRIES = 10;

    private static final double WINDOW = 10;

    /**
     * The longest time without a wall beside the robot, seconds: two full turns at 60 degrees a second for the spins, a
     * room of 12 m at 0.3 m/s for the search, and two circles of an arc.
     */
    private static final Map<FollowerState, Double> MAX_SECONDS = Map.of(
            FollowerState.SEARCH, 45.0,
            FollowerState.TURN, 12.0,
            FollowerState.MEASURE, 12.0,
            FollowerState.ALIGN, 6.0,
            FollowerState.FOLLOW, 12.0,
            FollowerState.ROUND, 30.0);

    /** The conditions of a run. */
    private enum Kind {
        SIX_STATES,
        DIAGNOSIS,
        DIAGNOSIS_AND_FAULT;

        SurvivalTrial trial(long room) {
            SplittableRandom random = new SplittableRandom(room);
            WallSide side = random.nextBoolean() ? WallSide.LEFT : WallSide.RIGHT;
            Conditions conditions = new Conditions(this != SIX_STATES, side, random.nextDouble(0.008), 0);
            boolean fails = this == DIAGNOSIS_AND_FAULT;
            DrawnFault fault = DrawnFault.values()[random.nextInt(DrawnFault.values().length)];
            return new SurvivalTrial(
                    room,
                    fails ? List.of(fault) : List.of(),
                    fails ? List.of(random.nextInt(8)) : List.of(),
                    0,
                    conditions);
        }
    }

    @Test
    void everyStateCanBeReachedAndLeft() {
        Set<FollowerState> reached = EnumSet.of(StateDiagram.INITIAL_STATE);
        Set<FollowerState> left = EnumSet.noneOf(FollowerState.class);
        for (int i = 0; i < FollowerState.values().length; i++) {
            for (StateDiagram.Arrow arrow : StateDiagram.TRANSITIONS) {
                left.add(arrow.from());
                if (reached.contains(arrow.from())) {
                    reached.add(arrow.to());
                }
            }
        }
        assertEquals(EnumSet.allOf(FollowerState.class), reached);
        assertEquals(EnumSet.allOf(FollowerState.class), left);
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void noStateLastsTooLongOrIsEnteredTooOften(Kind kind) {
        int visits = 0;
        for (long room = FIRST; room < FIRST + ROOMS; room++) {
            visits += visitStates(kind, room);
        }
        assertTrue(visits > 10 * ROOMS, visits + " visits in " + ROOMS + " rooms");
    }

    /** Runs a robot and returns the number of visits of states. */
    private static int visitStates(Kind kind, long room) {
        String name = kind + " in room " + room;
        Map<FollowerState, Deque<Double>> entries = new EnumMap<>(FollowerState.class);
        int visits = 0;
        try (Simulation simulation = new Simulation(kind.trial(room).setup(), ControllerMode.DIRECT)) {
            ControllerState last = simulation.telemetry().state();
            double since = 0;
            while (simulation.snapshot().time() < SECONDS
                    && simulation.snapshot().collision().isEmpty()) {
                simulation.tick();
                ControllerState now = simulation.telemetry().state();
                double time = simulation.snapshot().time();
                if (!now.equals(last)) {
                    visits++;
                    assertInDiagram(kind, last, now, name);
                    if (now instanceof FollowerState entered) {
                        Deque<Double> times = entries.computeIfAbsent(entered, state -> new ArrayDeque<>());
                        times.add(time);
                        times.removeIf(earlier -> earlier < time - WINDOW);
                        assertTrue(times.size() <= MAX_ENTRIES, () -> name + ": " + entered + " at " + times);
                    }
                    last = now;
                    since = time;
                } else if (seesWall(simulation)) {
                    since = time;
                }
                if (now instanceof FollowerState state) {
                    double lasted = time - since;
                    assertTrue(lasted <= MAX_SECONDS.get(state), () -> name + ": " + state + " at " + time + " s");
                }
            }
        }
        return visits;
    }

    /** The diagram is that of the six states alone; the fallback of the diagnosis may begin again in any of them. */
    private static void assertInDiagram(Kind kind, ControllerState from, ControllerState to, String name) {
        if (kind == Kind.SIX_STATES) {
            assertTrue(
                    StateDiagram.TRANSITIONS.stream().anyMatch(arrow -> arrow.from() == from && arrow.to() == to),
                    () -> name + ": from " + from + " to " + to);
        }
    }

    /** Returns whether the follower measures a distance to its wall, as beside a pillar that it rounds for ever. */
    private static boolean seesWall(Simulation simulation) {
        return Double.isFinite(simulation.telemetry().wall().measuredDistance());
    }
}
