package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ShapeHandles;
import faultline.paint.scene.ObstacleGroup;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.scene.SelectionPainter;
import faultline.paint.surface.Camera;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.Cursor;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Picks the gesture that a press of the mouse starts at a position on the canvas, and the cursor that announces it. */
public final class GesturePicker {

    private static final double HANDLE_TOLERANCE = SelectionPainter.HANDLE_RADIUS + Gesture.CLICK_TOLERANCE;

    /** The position of the menu of a selected cone, as a share of its range. */
    private static final double MENU_SHARE = 0.7;

    private final CanvasModel model;
    private final Viewport viewport;
    private final CommandSender sender;
    private final CanvasListeners listeners;
    /** What was selected last, if it was more than one obstacle. */
    private ObstacleGroup group = ObstacleGroup.NONE;

    public GesturePicker(CanvasModel model, Viewport viewport, CommandSender sender, CanvasListeners listeners) {
        this.model = model;
        this.viewport = viewport;
        this.sender = sender;
        this.listeners = listeners;
    }

    /** Returns the gesture of a press, with or without Shift or a modifier that rotates. */
    Gesture pick(Vector2 at, boolean left, boolean turns, boolean shift) {
        if (left && !shift) {
            Optional<DragOperation> handle = handleDrag(at);
            if (handle.isPresent()) {
                return dragGesture(handle.get(), at);
            }
        }
        Optional<Obstacle> under = ObstacleFinder.topmostAt(camera(), model.obstacles(), at);
        if (under.isPresent()) {
            return left && shift ? toggleSelection(under.get(), at) : obstacleGesture(under.get(), turns, at);
        }
        Optional<Snapshot> robot = robotAtStart(at);
        if (robot.isPresent()) {
            return new StartPoseGesture(robot.get(), turns, at, viewport, listeners);
        }
        Optional<SensorSnapshot> cone = turns ? selectedConeAt(at) : Optional.empty();
        if (cone.isPresent()) {
            return dragGesture(
                    DragOperation.TurnSensor.at(
                            camera().toWorld(at), expectedSpec(cone.get()), presentState(cone.get())),
                    at);
        }
        if (left && shift) {
            return new RubberBandGesture(model, viewport, at);
        }
        Runnable otherwise = left ? () -> selectSensorAt(at) : () -> {};
        Runnable click = ObstacleFinder.ofWaypointAt(model, camera(), at)
                .<Runnable>map(found -> () -> model.select(Set.of(found.id())))
                .orElse(otherwise);
        return isOnMovableRobot(at)
                ? new RobotUnderWayGesture(at, listeners, click)
                : new PanGesture(viewport, at, click);
    }

    private Optional<DragOperation> handleDrag(Vector2 at) {
        if (rotationHandle()
                .filter(place -> place.distanceTo(at) <= HANDLE_TOLERANCE)
                .isPresent()) {
            return Optional.of(new DragOperation.Rotate(model.selected(), camera().toWorld(at)));
        }
        return model.singleSelected()
                .flatMap(obstacle -> obstacleHandleDrag(obstacle, at))
                .or(() -> model.selectedSensor().flatMap(s -> coneDrag(s, at)));
    }

    private Optional<DragOperation> obstacleHandleDrag(Obstacle obstacle, Vector2 at) {
        OptionalInt resize = handleAt(ShapeHandles.positions(obstacle), at);
        if (resize.isPresent()) {
            return Optional.of(new DragOperation.Resize(expectedShape(obstacle), resize.getAsInt()));
        }
        // At a waypoint on the obstacle, the mouse moves the obstacle.
        boolean onObstacle =
                ObstacleFinder.topmostAt(camera(), List.of(obstacle), at).isPresent();
        OptionalInt waypoint =
                onObstacle ? OptionalInt.empty() : handleAt(obstacle.motion().waypoints(), at);
        return waypoint.isPresent()
                ? Optional.of(new DragOperation.MoveWaypoint(obstacle, waypoint.getAsInt(), this::expectedState))
                : Optional.empty();
    }

    /** Returns an obstacle as it will be when the run has answered, or as it is if it will have other handles. */
    private Obstacle expectedShape(Obstacle obstacle) {
        Obstacle expected = expectedState(obstacle);
        boolean sameHandles = ShapeHandles.positions(expected).size()
                == ShapeHandles.positions(obstacle).size();
        return sameHandles ? expected : obstacle;
    }

    /**
     * Returns an obstacle as it will be when the run has answered. It is where the frame shows it unless a command
     * moves it: the others have its pose of an earlier frame, and it may have moved since.
     */
    private Obstacle expectedState(Obstacle obstacle) {
        Obstacle shown = presentState(obstacle);
        Obstacle expected = sender.pendingEdits().expected(shown);
        boolean resized =
                !expected.withPose(shown.pose()).withMotion(shown.motion()).equals(shown);
        return resized || sender.pendingEdits().isMoved(shown.id()) ? expected : expected.withPose(shown.pose());
    }

    private Obstacle presentState(Obstacle obstacle) {
        return model.obstacles().stream()
                .filter(now -> now.id().equals(obstacle.id()))
                .findFirst()
                .orElse(obstacle);
    }

    /** Returns the position of the handle that rotates the selection. */
    private Optional<Vector2> rotationHandle() {
        List<Obstacle> selected = model.selected();
        if (selected.size() > 1) {
            group = group.with(selected);
            return Optional.of(SelectionPainter.handlePosition(camera(), group));
        }
        return selected.stream().findFirst().map(obstacle -> SelectionPainter.handlePosition(camera(), obstacle));
    }

    /** Returns the index of the first point whose handle is at a position on the canvas. */
    private OptionalInt handleAt(List<Vector2> points, Vector2 at) {
        return IntStream.range(0, points.size())
                .filter(i -> camera().toScreen(points.get(i)).distanceTo(at) <= HANDLE_TOLERANCE)
                .findFirst();
    }

    /** Returns the selected sensor if a position on the canvas is in its cone. */
    private Optional<SensorSnapshot> selectedConeAt(Vector2 at) {
        return ConeHitTest.sensorAt(camera(), model.selectedSensor().stream().toList(), at);
    }

    private Supplier<SensorSpec> expectedSpec(SensorSnapshot sensor) {
        return () -> sender.pendingEdits().robot().sensor(sensor.spec().id()).orElse(sensor.spec());
    }

    private Supplier<SensorSnapshot> presentState(SensorSnapshot sensor) {
        return () -> model.sensor(sensor.spec().id()).orElse(sensor);
    }

    private Optional<DragOperation> coneDrag(SensorSnapshot sensor, Vector2 at) {
        Supplier<SensorSpec> expected = expectedSpec(sensor);
        if (ConeHitTest.isOnArc(camera(), sensor.sector(), at)) {
            return Optional.of(new DragOperation.ChangeRange(expected.get(), expected, presentState(sensor)));
        }
        boolean edge = ConeHitTest.isOnEdge(camera(), sensor.sector(), at);
        return edge
                ? Optional.of(new DragOperation.ChangeCone(expected.get(), expected, presentState(sensor)))
                : Optional.empty();
    }

    private Gesture toggleSelection(Obstacle obstacle, Vector2 at) {
        model.toggleSelection(obstacle.id());
        return new PanGesture(viewport, at, () -> {});
    }

    private Gesture obstacleGesture(Obstacle obstacle, boolean turns, Vector2 at) {
        if (!model.isSelected(obstacle)) {
            model.select(Set.of(obstacle.id()));
        }
        Vector2 grip = camera().toWorld(at);
        return dragGesture(
                turns
                        ? new DragOperation.Rotate(model.selected(), grip)
                        : new DragOperation.Move(obstacle, model.selected(), grip),
                at);
    }

    private Gesture dragGesture(DragOperation drag, Vector2 at) {
        return new DragGesture(drag, at, model, viewport, sender);
    }

    /** Returns the world if its robot is at a position and has not started yet. */
    private Optional<Snapshot> robotAtStart(Vector2 at) {
        return model.frame().map(frame -> frame.snapshot()).filter(world -> world.tick() == 0 && isOnMovableRobot(at));
    }

    /** Returns whether a position is on a robot that can be moved while it has not started. */
    private boolean isOnMovableRobot(Vector2 at) {
        return listeners.hasStartListener() && model.isOnRobot(camera().toWorld(at));
    }

    private void selectSensorAt(Vector2 at) {
        model.select(Set.of());
        model.sensor().set(ConeHitTest.sensorAt(camera(), model.sensors(), at).map(sensor -> sensor.spec()
                .id()));
    }

    /** Returns a position on the selected obstacle or, without one, in the cone of the selected sensor. */
    Optional<Vector2> selectedPoint() {
        return model.singleSelected().flatMap(this::pointOf).or(() -> model.selectedSensor()
                .map(SensorSnapshot::sector)
                .map(cone -> cone.apex().plus(cone.axis().times(MENU_SHARE * cone.range())))
                .map(camera()::toScreen));
    }

    /** Returns the centre of an obstacle, or one of its handles where the centre is not part of it. */
    private Optional<Vector2> pointOf(Obstacle obstacle) {
        return Stream.concat(
                        Stream.of(ObstacleOutlines.centre(List.of(obstacle))),
                        ShapeHandles.positions(obstacle).stream())
                .map(camera()::toScreen)
                .filter(at -> ObstacleFinder.topmostAt(camera(), List.of(obstacle), at)
                        .isPresent())
                .findFirst();
    }

    /** Returns the cursor that announces what a press of the left button would do. */
    int cursorType(Vector2 at) {
        if (handleDrag(at).isPresent()) {
            return Cursor.HAND_CURSOR;
        }
        boolean movable =
                ObstacleFinder.topmostAt(camera(), model.obstacles(), at).isPresent()
                        || robotAtStart(at).isPresent();
        return movable ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR;
    }

    private Camera camera() {
        return viewport.camera().get();
    }
}
