package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.Obstacle;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Finds where the obstacles of a setup come from: they are there from the start, or a command of the timeline places
 * them.
 */
final class ObstacleOrigins {

    private static final NavigableSet<ExecutionPoint> NONE = new TreeSet<>();

    private static final CommandCases<Optional<String>> SUBJECT = CommandCases.ofSetup(
            empty(),
            empty(),
            moveObstacle -> Optional.of(moveObstacle.obstacle()),
            placeObstacle -> Optional.of(placeObstacle.obstacle().id()),
            removeObstacle -> Optional.of(removeObstacle.obstacle()),
            empty(),
            empty());

    /**
     * The origin of an obstacle.
     *
     * @param id the id of the obstacle
     * @param index the index of the command that places it, or {@link #START}
     */
    record Origin(String id, int index) {

        /** The index if the obstacle is there from the start. */
        private static final int START = -1;

        /** Returns the origin of an obstacle that is there from the start. */
        static Origin atStart(String id) {
            return new Origin(id, START);
        }

        boolean isAtStart() {
            return index == START;
        }
    }

    /** When a command of the timeline is executed: within a tick in the order of the list. */
    private record ExecutionPoint(long tick, int index) implements Comparable<ExecutionPoint> {

        private static final Comparator<ExecutionPoint> ORDER =
                Comparator.comparingLong(ExecutionPoint::tick).thenComparingInt(ExecutionPoint::index);

        @Override
        public int compareTo(ExecutionPoint other) {
            return ORDER.compare(this, other);
        }
    }

    private final SimulationSetup setup;
    /** When obstacles are placed, by their ids. */
    private final Map<String, NavigableSet<ExecutionPoint>> placements = new HashMap<>();

    ObstacleOrigins(SimulationSetup setup) {
        this.setup = setup;
        List<TimedCommand> timeline = setup.timeline();
        for (int i = 0; i < timeline.size(); i++) {
            if (timeline.get(i).command() instanceof Command.PlaceObstacle command) {
                placements
                        .computeIfAbsent(command.obstacle().id(), id -> new TreeSet<>())
                        .add(execution(i));
            }
        }
    }

    private ExecutionPoint execution(int index) {
        return new ExecutionPoint(setup.tickAt(setup.timeline().get(index).time()), index);
    }

    private static <C> Function<C, Optional<String>> empty() {
        return command -> Optional.empty();
    }

    /** Returns the id of the obstacle that a command is about; empty if it is about something else. */
    static Optional<String> subject(Command command) {
        return command.match(SUBJECT);
    }

    /** Returns the ids of the obstacles of a setup, at the start and on its timeline. */
    static Set<String> idsIn(SimulationSetup setup) {
        return Stream.concat(
                        setup.world().obstacles().stream().map(Obstacle::id),
                        setup.timeline().stream().flatMap(timed -> subject(timed.command()).stream()))
                .collect(Collectors.toSet());
    }

    /** Returns the origin of the obstacle that a command from outside is about, which is executed at a tick. */
    Origin at(long tick, String id) {
        return last(new ExecutionPoint(tick, Integer.MAX_VALUE), id);
    }

    /**
     * Returns the origin of the obstacle that a command of the timeline is about, given the index of the command; empty
     * if it is about something else. A command that places an obstacle is its origin.
     */
    Optional<Origin> of(int index) {
        return subject(setup.timeline().get(index).command()).map(id -> last(execution(index), id));
    }

    /** Returns all origins that the obstacles of an id may have. */
    Stream<Origin> all(String id) {
        return Stream.concat(
                Stream.of(Origin.atStart(id)),
                placements.getOrDefault(id, NONE).stream().map(placement -> new Origin(id, placement.index())));
    }

    private Origin last(ExecutionPoint until, String id) {
        ExecutionPoint placement = placements.getOrDefault(id, NONE).floor(until);
        return placement == null ? Origin.atStart(id) : new Origin(id, placement.index());
    }
}
