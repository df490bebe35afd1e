package faultline.gui.change;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.change.ObstacleOrigins.Origin;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * The obstacles of a setup under edits. A change holds from the start, or from the command of the timeline on that
 * places the obstacle. The timeline's commands about an obstacle that has been removed are hidden until it is placed
 * again.
 */
final class EditedObstacles {

    private final SimulationSetup base;
    private final ObstacleOrigins origins;
    /**
     * The obstacles by their origins, including the removed ones, so that an obstacle that is placed again takes its
     * old position in the order.
     */
    private final Map<Origin, Obstacle> obstacles = new LinkedHashMap<>();

    private final Set<Origin> removed = new HashSet<>();

    /** Takes the obstacles of a setup without edits. */
    EditedObstacles(SimulationSetup base) {
        this.base = base;
        this.origins = new ObstacleOrigins(base);
        addObstacles();
    }

    /**
     * Takes the obstacles of a setup without edits.
     *
     * @param base the setup
     * @param hidden the indices of the hidden commands of its timeline
     * @param before the obstacles before, from which the order of the obstacles and the removed ones are taken
     */
    private EditedObstacles(SimulationSetup base, Set<Integer> hidden, EditedObstacles before) {
        this.base = base;
        this.origins = new ObstacleOrigins(base);
        before.obstacles.forEach((origin, obstacle) -> {
            if (origin.isAtStart()) {
                obstacles.put(origin, obstacle);
                removed.add(origin);
            }
        });
        addObstacles();
        hidden.forEach(index -> origins.of(index)
                .filter(origin -> !origin.isAtStart() || !obstacles.containsKey(origin))
                .ifPresent(removed::add));
    }

    private void addObstacles() {
        base.world().obstacles().forEach(obstacle -> addObstacle(Origin.atStart(obstacle.id()), obstacle));
        for (int i = 0; i < base.timeline().size(); i++) {
            if (base.timeline().get(i).command() instanceof Command.PlaceObstacle command) {
                addObstacle(origins.of(i).orElseThrow(), command.obstacle());
            }
        }
    }

    private void addObstacle(Origin origin, Obstacle obstacle) {
        obstacles.put(origin, obstacle);
        removed.remove(origin);
    }

    private EditedObstacles(EditedObstacles other) {
        this.base = other.base;
        this.origins = other.origins;
        take(other);
    }

    /** Replaces the obstacles by others with the same origins. */
    void take(EditedObstacles other) {
        obstacles.clear();
        obstacles.putAll(other.obstacles);
        removed.clear();
        removed.addAll(other.removed);
    }

    /**
     * Returns the obstacles of another setup without edits. If its timeline lacks some commands, they are put back, and
     * those that are hidden now remain hidden.
     *
     * @param setup the setup
     * @param commands the commands, by their indices in the timeline with them
     */
    EditedObstacles rebased(SimulationSetup setup, SortedMap<Integer, TimedCommand> commands) {
        if (commands.isEmpty()) {
            return new EditedObstacles(setup, Set.of(), this);
        }
        Set<TimedCommand> present = Set.copyOf(setup.timeline());
        Set<Integer> hiddenNow = hidden().keySet();
        List<TimedCommand> timeline = new ArrayList<>(setup.timeline());
        Set<Integer> hidden = new HashSet<>();
        commands.forEach((place, command) -> {
            if (!present.contains(command)) {
                int index = Math.min(place, timeline.size());
                timeline.add(index, command);
                if (hiddenNow.contains(place)) {
                    hidden.add(index);
                }
            }
        });
        return new EditedObstacles(setup.withTimeline(timeline), hidden, this);
    }

    /** Returns the setup before the edits, with the hidden commands in its timeline. */
    SimulationSetup base() {
        return base;
    }

    EditedObstacles copy() {
        return new EditedObstacles(this);
    }

    /** Returns these obstacles with another id of a sensor or an obstacle in them and in their setup. */
    EditedObstacles renamed(Rename rename) {
        EditedObstacles result = new EditedObstacles(rename.rename(base));
        result.take(this);
        result.rename(rename);
        return result;
    }

    /** Gives the obstacles, but not their setup, the ids that they have after a change of an id. */
    void rename(Rename rename) {
        EditedObstacles before = copy();
        obstacles.clear();
        removed.clear();
        before.obstacles.forEach((origin, obstacle) -> obstacles.put(origin.renamed(rename), rename.rename(obstacle)));
        before.removed.forEach(origin -> removed.add(origin.renamed(rename)));
    }

    /** Returns the origin of the obstacle that a command at a tick is about. */
    Origin originAt(long tick, String id) {
        return origins.at(tick, id);
    }

    /** Moves an obstacle at a tick; one that does not exist is ignored. */
    void move(long tick, String id, Pose pose) {
        Origin origin = origins.at(tick, id);
        if (!removed.contains(origin)) {
            obstacles.computeIfPresent(origin, (same, obstacle) -> obstacle.withPose(pose));
        }
    }

    /** Adds an obstacle at a tick, or replaces the one of this id. */
    void place(long tick, Obstacle obstacle) {
        addObstacle(origins.at(tick, obstacle.id()), obstacle);
    }

    /** Removes an obstacle at a tick; one that does not exist is ignored. */
    void remove(long tick, String id) {
        Origin origin = origins.at(tick, id);
        if (obstacles.containsKey(origin)) {
            removed.add(origin);
        }
    }

    /** Returns what moves an obstacle, after an edit at a tick, back to where it is now. */
    Consumer<EditedObstacles> moveBack(long tick, String id) {
        Origin origin = origins.at(tick, id);
        Optional<Pose> before = Optional.ofNullable(obstacles.get(origin)).map(Obstacle::pose);
        return edited -> before.ifPresent(
                pose -> edited.obstacles.computeIfPresent(origin, (same, obstacle) -> obstacle.withPose(pose)));
    }

    /** Returns what restores, after an edit at a tick, what is known of an obstacle now. */
    Consumer<EditedObstacles> reversal(long tick, String id) {
        Origin origin = origins.at(tick, id);
        Obstacle before = obstacles.get(origin);
        boolean wasRemoved = removed.contains(origin);
        return edited -> edited.restore(origin, before, wasRemoved);
    }

    /** Restores what was known of an obstacle, null if nothing was. */
    private void restore(Origin origin, Obstacle before, boolean wasRemoved) {
        obstacles.compute(origin, (same, now) -> before);
        if (wasRemoved) {
            removed.add(origin);
        } else {
            removed.remove(origin);
        }
    }

    /** Returns whether an obstacle is there at a tick, unless the timeline has removed it. */
    boolean contains(long tick, String id) {
        return contains(origins.at(tick, id));
    }

    /** Returns an obstacle of the world at the start that has changed; empty if it has not. */
    Optional<Obstacle> changedAtStart(String id) {
        return Optional.ofNullable(obstacles.get(Origin.atStart(id)))
                .filter(obstacle -> !base.world().obstacles().contains(obstacle));
    }

    /** Replaces an obstacle of the world at the start. */
    void changeAtStart(Obstacle obstacle) {
        obstacles.put(Origin.atStart(obstacle.id()), obstacle);
    }

    /** Reverts the change of an obstacle at the start; returns false if it has not changed. It is in the world. */
    boolean revertAtStart(String id) {
        Optional<Obstacle> before = base.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst();
        Origin origin = Origin.atStart(id);
        if (before.equals(Optional.ofNullable(obstacles.get(origin)))) {
            return false;
        }
        before.ifPresentOrElse(obstacle -> obstacles.put(origin, obstacle), () -> removed.add(origin));
        return true;
    }

    /**
     * Returns the world with the obstacles at the start. It allows more moving obstacles than before if an edit has
     * added one after the timeline had removed another.
     */
    WorldSpec world() {
        List<Obstacle> atStart = obstacles.entrySet().stream()
                .filter(entry -> entry.getKey().isAtStart() && !removed.contains(entry.getKey()))
                .map(Map.Entry::getValue)
                .toList();
        int moving = (int) atStart.stream().filter(Obstacle::isMoving).count();
        WorldSpec world = base.world();
        return new WorldSpec(
                world.width(), world.height(), world.enclosed(), Math.max(world.maxMoving(), moving), atStart);
    }

    /** Returns the timeline without the hidden commands. */
    List<TimedCommand> timeline() {
        SortedMap<Integer, TimedCommand> hidden = hidden();
        return IntStream.range(0, base.timeline().size())
                .filter(i -> !hidden.containsKey(i))
                .mapToObj(this::edited)
                .toList();
    }

    /** Returns a timeline in which edited commands are those before the edits. */
    List<TimedCommand> withoutEdits(List<TimedCommand> timeline) {
        Map<TimedCommand, TimedCommand> originals = new HashMap<>();
        for (int i = 0; i < base.timeline().size(); i++) {
            if (base.timeline().get(i).command() instanceof Command.PlaceObstacle) {
                originals.put(edited(i), base.timeline().get(i));
            }
        }
        return timeline.stream()
                .map(command -> originals.getOrDefault(command, command))
                .toList();
    }

    private TimedCommand edited(int index) {
        TimedCommand timed = base.timeline().get(index);
        return timed.command() instanceof Command.PlaceObstacle
                ? new TimedCommand(
                        timed.time(),
                        new Command.PlaceObstacle(
                                obstacles.get(origins.of(index).orElseThrow())))
                : timed;
    }

    /** Returns the hidden commands by their indices in the timeline. */
    SortedMap<Integer, TimedCommand> hidden() {
        Map<String, Boolean> existing = new HashMap<>();
        SortedMap<Integer, TimedCommand> hidden = new TreeMap<>();
        for (int i = 0; i < base.timeline().size(); i++) {
            Optional<Origin> origin = origins.of(i);
            // A command that comes too early for its obstacle has no effect, but is not allowed without the obstacle.
            if (origin.filter(from -> removed.contains(from) || !existing.computeIfAbsent(from.id(), this::exists))
                    .isPresent()) {
                hidden.put(i, base.timeline().get(i));
            }
        }
        return hidden;
    }

    /** Returns whether there is an obstacle of an id at any time. */
    private boolean exists(String id) {
        return origins.all(id).anyMatch(this::contains);
    }

    private boolean contains(Origin origin) {
        return obstacles.containsKey(origin) && !removed.contains(origin);
    }
}
