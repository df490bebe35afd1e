package faultline.gui.canvas.tool;

import faultline.engine.Frame;
import faultline.geometry.Vector2;
import faultline.gui.edit.IdGenerator;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ReferenceOverlay;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/** The frame and the layers that are shown, and the selected obstacles and sensor. */
public final class CanvasModel {

    private final ObservableValue<Set<String>> selection = new ObservableValue<>(Set.of());
    private final ObservableValue<Optional<String>> sensor = new ObservableValue<>(Optional.empty());
    private final ObservableValue<Optional<ReferenceOverlay>> referenceOverlay =
            new ObservableValue<>(Optional.empty());
    private final Set<Layer> layers = Layer.defaults();
    private boolean collisionReported = true;
    private Supplier<Set<String>> reservedIds = Set::of;
    private Frame frame;
    private Set<String> pendingSelection = Set.of();
    /** The sensor that is selected as soon as a frame has it, empty for none. */
    private String pendingSensor = "";

    /** Sets the frame; selected objects that it lacks are deselected, and awaited ones selected. */
    public void setFrame(Frame newest) {
        frame = newest;
        if (hasAny(pendingSelection)) {
            select(pendingSelection);
        } else if (!hasAll(selection.get())) {
            select(selection.get(), pendingSelection);
        }
        if (sensor(pendingSensor).isPresent()) {
            sensor.set(Optional.of(pendingSensor));
            pendingSensor = "";
        } else if (selectedSensor().isEmpty()) {
            sensor.set(Optional.empty());
        }
    }

    /** Gives the selected sensor the id that it has in the next frame, as returned for the present one. */
    public void renameSensors(UnaryOperator<String> presentId) {
        pendingSensor = presentId.apply(pendingSensor);
        sensor.set(sensor.get().map(presentId));
    }

    /** Lets the selected obstacles be selected in the next frame by the ids there, as returned for the present ones. */
    public void renameObstacles(UnaryOperator<String> nextId) {
        Set<String> awaited = pendingSelection.isEmpty() ? selection.get() : pendingSelection;
        pendingSelection = awaited.stream().map(nextId).collect(Collectors.toUnmodifiableSet());
    }

    public Optional<Frame> frame() {
        return Optional.ofNullable(frame);
    }

    /** Returns an unmodifiable view of the layers that are shown. */
    public Set<Layer> layers() {
        return Collections.unmodifiableSet(layers);
    }

    /** Shows or hides a layer. */
    public void setLayer(Layer layer, boolean on) {
        if (on) {
            layers.add(layer);
        } else {
            layers.remove(layer);
        }
    }

    /** Sets whether the first collision is reported in the picture. */
    public void setCollisionReported(boolean reported) {
        collisionReported = reported;
    }

    public boolean isCollisionReported() {
        return collisionReported;
    }

    public ObservableValue<Set<String>> selection() {
        return selection;
    }

    /** Returns the reference run that is shown. */
    public ObservableValue<Optional<ReferenceOverlay>> referenceOverlay() {
        return referenceOverlay;
    }

    /** Returns the id of the selected sensor. */
    public ObservableValue<Optional<String>> sensor() {
        return sensor;
    }

    private boolean hasAny(Set<String> ids) {
        return !ids.isEmpty() && obstacles().stream().anyMatch(obstacle -> ids.contains(obstacle.id()));
    }

    /** Ids are unique, so counting is enough; this is called for every frame. */
    private boolean hasAll(Set<String> ids) {
        return ids.isEmpty()
                || obstacles().stream()
                                .filter(obstacle -> ids.contains(obstacle.id()))
                                .count()
                        == ids.size();
    }

    /** Selects obstacles, and nothing else if there are any of them; unknown ids are ignored. */
    public void select(Collection<String> wanted) {
        select(wanted, Set.of());
    }

    private void select(Collection<String> wanted, Set<String> nowPending) {
        pendingSelection = nowPending;
        Set<String> there = new LinkedHashSet<>(wanted);
        there.retainAll(obstacleIds());
        selection.set(Collections.unmodifiableSet(there));
        if (!there.isEmpty()) {
            sensor.set(Optional.empty());
        }
    }

    /** Selects obstacles that are added together: those that the first frame with any of them has. */
    public void selectWhenPresent(Collection<String> ids) {
        pendingSelection = Set.copyOf(ids);
    }

    /** Selects a sensor as soon as a frame has it. */
    public void selectSensorWhenPresent(String id) {
        pendingSensor = id;
    }

    /** Adds an obstacle to the selection, or removes it. */
    public void toggleSelection(String id) {
        Set<String> changed = new LinkedHashSet<>(selection.get());
        if (!changed.remove(id)) {
            changed.add(id);
        }
        select(changed);
    }

    /** Returns whether a point of the world is on the platform of the robot; false without a frame. */
    boolean isOnRobot(Vector2 point) {
        if (frame == null) {
            return false;
        }
        Snapshot world = frame.snapshot();
        Vector2 local = world.pose().toLocal(point);
        return Math.abs(local.x()) <= world.robot().length() / 2
                && Math.abs(local.y()) <= world.robot().width() / 2;
    }

    /** Returns whether the run has made a tick. */
    boolean hasStarted() {
        return frame != null && frame.snapshot().tick() > 0;
    }

    public boolean isSelected(Obstacle obstacle) {
        return selection.get().contains(obstacle.id());
    }

    public List<Obstacle> obstacles() {
        return frame == null ? List.of() : frame.snapshot().obstacles();
    }

    public Set<String> obstacleIds() {
        return obstacles().stream().map(Obstacle::id).collect(Collectors.toSet());
    }

    /** Sets the function that returns further ids that new obstacles must not have. */
    public void setReservedIds(Supplier<Set<String>> newReservedIds) {
        reservedIds = newReservedIds;
    }

    /** Returns an id for a new obstacle: a wanted one, or a similar one if it is taken. */
    String newId(String wanted) {
        return IdGenerator.uniqueId(wanted, takenIds());
    }

    /** Returns the ids that a new obstacle must not have. */
    public Set<String> takenIds() {
        Set<String> taken = new HashSet<>(reservedIds.get());
        taken.addAll(obstacleIds());
        return taken;
    }

    /** Returns the selected obstacles, in drawing order. */
    public List<Obstacle> selected() {
        // Usually nothing is selected, and there may be a hundred thousand obstacles.
        return selection.get().isEmpty()
                ? List.of()
                : obstacles().stream().filter(this::isSelected).toList();
    }

    /** Returns the selected obstacle; empty if none or several are selected. */
    public Optional<Obstacle> singleSelected() {
        List<Obstacle> selected = selected();
        return selected.size() == 1 ? Optional.of(selected.get(0)) : Optional.empty();
    }

    public List<SensorSnapshot> sensors() {
        return frame == null ? List.of() : frame.snapshot().sensors();
    }

    public Optional<SensorSnapshot> sensor(String id) {
        return sensors().stream()
                .filter(candidate -> candidate.spec().id().equals(id))
                .findFirst();
    }

    public Optional<SensorSnapshot> selectedSensor() {
        return sensor.get().flatMap(this::sensor);
    }
}
