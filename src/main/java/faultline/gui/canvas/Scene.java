package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.paint.Ghost;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** The frame that shows, and which of its obstacles and which of its sensors are selected. */
final class Scene {

    private final Watched<Set<String>> selection = new Watched<>(Set.of());
    private final Watched<Optional<String>> sensor = new Watched<>(Optional.empty());
    private final Watched<Optional<Ghost>> ghost = new Watched<>(Optional.empty());
    private Optional<Frame> frame = Optional.empty();
    private Set<String> awaited = Set.of();

    /** Takes a newer frame; what it lacks is no longer selected, and what was awaited is. */
    void show(Frame newest) {
        frame = Optional.of(newest);
        if (!awaited.isEmpty() && hasAll(awaited)) {
            select(awaited);
        } else if (!hasAll(selection.get())) {
            select(selection.get(), awaited);
        }
        if (selectedSensor().isEmpty()) {
            sensor.set(Optional.empty());
        }
    }

    Optional<Frame> frame() {
        return frame;
    }

    Watched<Set<String>> selection() {
        return selection;
    }

    /** The earlier run that shows beside the frame's. */
    Watched<Optional<Ghost>> ghost() {
        return ghost;
    }

    /** The id of the selected sensor. */
    Watched<Optional<String>> sensor() {
        return sensor;
    }

    /** Looked at with every frame: no two obstacles have the same id, so it is enough to count. */
    private boolean hasAll(Set<String> ids) {
        return ids.isEmpty() || obstacles().stream().filter(obstacle -> ids.contains(obstacle.id())).count() == ids.size();
    }

    /** Selects obstacles and no others; those that are not there are left out. */
    void select(Collection<String> wanted) {
        select(wanted, Set.of());
    }

    private void select(Collection<String> wanted, Set<String> nowAwaited) {
        awaited = nowAwaited;
        Set<String> there = new LinkedHashSet<>(wanted);
        there.retainAll(ids());
        selection.set(Collections.unmodifiableSet(there));
    }

    /** Selects obstacles as soon as a frame has them all. */
    void await(Collection<String> ids) {
        awaited = Set.copyOf(ids);
    }

    /** Selects an obstacle besides the others, or no longer. */
    void toggle(String id) {
        Set<String> changed = new LinkedHashSet<>(selection.get());
        if (!changed.remove(id)) {
            changed.add(id);
        }
        select(changed);
    }

    boolean isSelected(Obstacle obstacle) {
        return selection.get().contains(obstacle.id());
    }

    List<Obstacle> obstacles() {
        return frame.map(f -> f.world().obstacles()).orElse(List.of());
    }

    Set<String> ids() {
        return obstacles().stream().map(Obstacle::id).collect(Collectors.toSet());
    }

    /** The selected obstacles, in drawing order. */
    List<Obstacle> selected() {
        return obstacles().stream().filter(this::isSelected).toList();
    }

    /** The selected obstacle, empty where none or several are. */
    Optional<Obstacle> single() {
        List<Obstacle> selected = selected();
        return selected.size() == 1 ? Optional.of(selected.get(0)) : Optional.empty();
    }

    List<SensorSnapshot> sensors() {
        return frame.map(f -> f.world().sensors()).orElse(List.of());
    }

    Optional<SensorSnapshot> sensor(String id) {
        return sensors().stream().filter(candidate -> candidate.spec().id().equals(id)).findFirst();
    }

    Optional<SensorSnapshot> selectedSensor() {
        return sensor.get().flatMap(this::sensor);
    }
}
