package faultline.gui.change;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.Obstacle;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Finds where the obstacles of a setup come from: they are there from the start, or a command of the timeline places
 * them.
 */
public final class ObstacleOrigins {

    private static final NavigableMap<ExecutionPoint, Origin> NONE = new TreeMap<>();

    private static final CommandCases<Optional<String>> SUBJECT = CommandCases.ofSetup(
            empty(),
            empty(),
            moveObstacle -> Optional.of(moveObstacle.obstacle()),
            placeObstacle -> Optional.of(placeObstacle.obstacle().id()),
            removeObstacle -> Optional.of(removeObstacle.obstacle()),
            empty(),
            empty());

    /**
     * The origin of an obstacle. It stays the same when commands about other obstacles are added or removed.
     *
     * @param id the id of the obstacle
     * @param placement the number of the command among those that place an obstacle of this id, in the order of
     *     execution, from 1; {@link #START} if there is none
     */
    record Origin(String id, int placement) {

        /** The number of placements if the obstacle is there from the start. */
        private static final int START = 0;

        /** Returns the origin of an obstacle that is there from the start. */
        static Origin atStart(String id) {
            return new Origin(id, START);
        }

        boolean isAtStart() {
            return placement == START;
        }

        /** Returns the origin after a change of an id. */
        Origin renamed(Rename rename) {
            return new Origin(rename.renameObstacle(id), placement);
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
    /** When obstacles are placed, and the origins that they have then, by their ids. */
    private final Map<String, NavigableMap<ExecutionPoint, Origin>> placements = new HashMap<>();

    ObstacleOrigins(SimulationSetup setup) {
        this.setup = setup;
        List<TimedCommand> timeline = setup.timeline();
        for (int i = 0; i < timeline.size(); i++) {
            if (timeline.get(i).command() instanceof Command.PlaceObstacle command) {
                placements
                        .computeIfAbsent(command.obstacle().id(), id -> new TreeMap<>())
                        .put(execution(i), Origin.atStart(command.obstacle().id()));
            }
        }
        placements.values().forEach(ObstacleOrigins::count);
    }

    private static void count(NavigableMap<ExecutionPoint, Origin> placements) {
        int placement = Origin.START;
        for (Map.Entry<ExecutionPoint, Origin> entry : placements.entrySet()) {
            placement++;
            entry.setValue(new Origin(entry.getValue().id(), placement));
        }
    }

    private ExecutionPoint execution(int index) {
        return new ExecutionPoint(setup.tickAt(setup.timeline().get(index).time()), index);
    }

    private static <C> Function<C, Optional<String>> empty() {
        return command -> Optional.empty();
    }

    /** Returns the id of the obstacle that a command is about; empty if it is about something else. */
    public static Optional<String> subject(Command command) {
        return command.match(SUBJECT);
    }

    /** Returns the ids of the obstacles of a setup, at the start and on its timeline. */
    public static Set<String> idsIn(SimulationSetup setup) {
        return Stream.concat(
                        setup.world().obstacles().stream().map(Obstacle::id),
                        setup.timeline().stream().flatMap(timed -> subject(timed.command()).stream()))
                .collect(Collectors.toSet());
    }

    /** Returns whether two setups have the same obstacles at all times, so that their origins are the same, too. */
    static boolean areEqual(SimulationSetup setup, SimulationSetup other) {
        return setup.dt() == other.dt()
                && setup.world().equals(other.world())
                && commands(setup).equals(commands(other));
    }

    /** Returns the commands of a timeline that are about obstacles. */
    private static List<TimedCommand> commands(SimulationSetup setup) {
        return setup.timeline().stream()
                .filter(timed -> subject(timed.command()).isPresent())
                .toList();
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
        return Stream.concat(Stream.of(Origin.atStart(id)), placements.getOrDefault(id, NONE).values().stream());
    }

    private Origin last(ExecutionPoint until, String id) {
        Map.Entry<ExecutionPoint, Origin> placement =
                placements.getOrDefault(id, NONE).floorEntry(until);
        return placement == null ? Origin.atStart(id) : placement.getValue();
    }
}
