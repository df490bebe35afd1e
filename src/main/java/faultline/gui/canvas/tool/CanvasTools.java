package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.ObstacleCopies;
import faultline.gui.edit.PointShapes;
import faultline.gui.edit.Rounding;
import faultline.gui.edit.ShapePreset;
import faultline.gui.edit.SnapSettings;
import faultline.gui.text.Messages;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.surface.Camera;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import faultline.world.WaypointPath;
import java.awt.EventQueue;
import java.awt.Point;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;

/** The tools, the snap settings, the selection and the listeners of a canvas. Event dispatch thread only. */
public final class CanvasTools {

    /** The speed of an obstacle that is given waypoints, metres per second. */
    private static final double DEFAULT_SPEED = 0.2;

    private final ToolContext context;
    private final CanvasMouse mouse;
    private final JComponent canvas;
    /** The id of the obstacle whose path is drawn, or was drawn last; empty before. */
    private String movingObstacle = "";

    public CanvasTools(ToolContext context, CanvasMouse mouse, JComponent canvas) {
        this.context = context;
        this.mouse = mouse;
        this.canvas = canvas;
    }

    /** Activates a tool that places one shape. */
    public void placeShape(ShapePreset shape) {
        activate(new PlaceTool(shape, context));
    }

    /** Activates a tool that draws a wall from point to point. */
    public void drawWall() {
        activate(new PointsTool(
                context,
                mouse.keyPoint(),
                2,
                false,
                points -> context.placeObstacle(PointShapes.wall(context.model().newId("wall"), points))));
    }

    /** Activates a tool that draws a polygon from corner to corner, or freehand. */
    public void drawPolygon() {
        activate(new PointsTool(context, mouse.keyPoint(), 3, true, this::placePolygon));
    }

    private boolean placePolygon(List<Vector2> points) {
        if (PointShapes.areOnOneLine(points)) {
            context.showNote(Messages.get("tool.line"));
            return false;
        }
        return context.placeObstacle(PointShapes.polygon(context.model().newId("polygon"), points));
    }

    /**
     * Activates a tool that draws the path of the selected obstacle, from where it stands; does nothing unless exactly
     * one obstacle is selected.
     */
    public void drawMotionPath() {
        context.model().singleSelected().ifPresent(obstacle -> {
            movingObstacle = obstacle.id();
            activate(new PointsTool(context, mouse.keyPoint(), 1, true, this::setMotionPath));
        });
    }

    /** Activates a tool that measures distances and angles until it is cancelled. */
    public void measure() {
        activate(new MeasureTool(() ->
                Gesture.CLICK_TOLERANCE / context.viewport().camera().get().scale()));
    }

    private boolean setMotionPath(List<Vector2> points) {
        List<Obstacle> shown = context.model().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(movingObstacle))
                .toList();
        for (Obstacle obstacle : context.sender().pendingEdits().expected(shown)) {
            List<Vector2> waypoints = new ArrayList<>(points);
            waypoints.add(obstacle.pose().position());
            double speed = obstacle.isMoving() ? obstacle.motion().speed() : DEFAULT_SPEED;
            WaypointPath motion = new WaypointPath(speed, true, waypoints);
            context.sender().send(new Command.PlaceObstacle(obstacle.withMotion(motion)));
        }
        return true;
    }

    /** Ends the active tool, so that the left button selects and moves. */
    public void endTool() {
        assert EventQueue.isDispatchThread();
        mouse.cancel();
        canvas.requestFocusInWindow();
        canvas.repaint();
    }

    /** Activates a tool in place of the active one, whose point it takes over if keys have set it. */
    private void activate(Tool tool) {
        assert EventQueue.isDispatchThread();
        mouse.cancelGesture();
        mouse.tool().set(Optional.of(tool));
        canvas.requestFocusInWindow();
        canvas.repaint();
    }

    /** Adds a listener that is called with whether a tool is active, when that changes. */
    public void addToolListener(Consumer<Boolean> listener) {
        mouse.tool().addListener(tool -> listener.accept(tool.isPresent()));
    }

    /** Sets the steps that positions and angles are rounded to while Alt is not held. */
    public void setSnap(SnapSettings snap) {
        mouse.setSnap(snap);
    }

    /** Returns whether a frame is shown. */
    public boolean hasFrame() {
        return context.model().frame().isPresent();
    }

    /**
     * Sets the function that returns the ids of obstacles that the scenario has at other times, which new obstacles
     * must not have.
     */
    public void setReservedIds(Supplier<Set<String>> reservedIds) {
        context.model().setReservedIds(reservedIds);
    }

    /** Returns the ids that a new obstacle must not have. */
    public Set<String> takenIds() {
        return context.model().takenIds();
    }

    /** Returns the selected obstacles of the frame that is shown, in drawing order. */
    public List<Obstacle> selected() {
        return context.model().selected();
    }

    /** Returns the selected obstacles as they will be after the commands that were sent, in drawing order. */
    public List<Obstacle> expectedSelection() {
        return context.expectedSelection();
    }

    /** Selects obstacles and no others; unknown ids are ignored. */
    public void select(Collection<String> ids) {
        assert EventQueue.isDispatchThread();
        context.model().select(ids);
    }

    /** Selects all obstacles. */
    public void selectAll() {
        select(context.model().obstacles().stream().map(Obstacle::id).toList());
    }

    /** Selects the obstacle a number of steps after the selected one in drawing order, or the first or last one. */
    public void selectNext(int step) {
        List<String> ids =
                context.model().obstacles().stream().map(Obstacle::id).toList();
        if (!ids.isEmpty()) {
            int current = selected().isEmpty()
                    ? step > 0 ? -1 : 0
                    : ids.indexOf(selected().get(0).id());
            select(List.of(ids.get(Math.floorMod(current + step, ids.size()))));
            canvas.requestFocusInWindow();
        }
    }

    /**
     * Returns the displacement that brings the centre of obstacles into the view if it lies outside of the world. A
     * frame must be shown.
     */
    public Vector2 displacementIntoView(List<Obstacle> obstacles) {
        Snapshot world = context.model().frame().orElseThrow().snapshot();
        Vector2 centre = ObstacleOutlines.centre(obstacles);
        boolean inside =
                centre.x() >= 0 && centre.x() <= world.width() && centre.y() >= 0 && centre.y() <= world.height();
        Camera camera = context.viewport().camera().get();
        Vector2 target = new Vector2(
                Math.max(0, Math.min(world.width(), camera.x())), Math.max(0, Math.min(world.height(), camera.y())));
        return inside ? Vector2.ZERO : Rounding.round(target.minus(centre));
    }

    /**
     * Returns the displacement of copies of some obstacles from them, which keeps the copies in the room and visible. A
     * frame must be shown.
     */
    public Vector2 offsetOfCopies(List<Obstacle> originals) {
        Snapshot world = context.model().frame().orElseThrow().snapshot();
        List<Vector2> others = world.obstacles().stream()
                .map(obstacle -> ObstacleOutlines.centre(List.of(obstacle)))
                .toList();
        return ObstacleCopies.offset(ObstacleOutlines.centre(originals), world.width(), world.height(), others);
    }

    /** Returns what is at a position on the canvas, so that a menu may suit it. */
    public MenuTarget targetAt(Point at) {
        Camera camera = context.viewport().camera().get();
        Vector2 screen = new Vector2(at.x, at.y);
        CanvasModel model = context.model();
        if (ObstacleFinder.topmostAt(camera, model.obstacles(), screen).isPresent()) {
            return MenuTarget.OBSTACLE;
        }
        if (model.isOnRobot(camera.toWorld(screen))) {
            return MenuTarget.ROBOT;
        }
        if (ObstacleFinder.ofWaypointAt(model, camera, screen).isPresent()) {
            return MenuTarget.OBSTACLE;
        }
        return ConeHitTest.sensorAt(camera, model.sensors(), screen).isPresent() ? MenuTarget.SENSOR : MenuTarget.FLOOR;
    }

    /** Selects the sensor whose cone is at a position on the canvas, and no obstacle; returns the sensor. */
    public Optional<SensorSnapshot> selectSensorAt(Point at) {
        Optional<SensorSnapshot> sensor = ConeHitTest.sensorAt(
                context.viewport().camera().get(), context.model().sensors(), new Vector2(at.x, at.y));
        context.model().select(Set.of());
        context.model().sensor().set(sensor.map(found -> found.spec().id()));
        return sensor;
    }

    /** Selects obstacles that are about to be placed: in the first frame that has any of them, those that it has. */
    public void selectWhenPresent(Collection<String> ids) {
        context.model().selectWhenPresent(ids);
    }

    /** Adds a listener that is called with the ids of the selected obstacles when they change. */
    public void addSelectionListener(Consumer<Set<String>> listener) {
        context.model().selection().addListener(listener);
    }

    /** Selects a sensor; one that does not exist clears the selection. */
    public void selectSensor(String id) {
        assert EventQueue.isDispatchThread();
        context.model().sensor().set(context.model().sensor(id).map(sensor -> sensor.spec()
                .id()));
    }

    /** Gives the selected sensor the id that it has in the next frame, as returned for the present one. */
    public void renameSensors(UnaryOperator<String> presentId) {
        context.model().renameSensors(presentId);
    }

    /** Lets the selected obstacles be selected in the next frame by the ids there, as returned for the present ones. */
    public void renameObstacles(UnaryOperator<String> nextId) {
        context.model().renameObstacles(nextId);
        movingObstacle = nextId.apply(movingObstacle);
        mouse.renameObstacles(nextId);
    }

    /** Selects a sensor that is about to be added, and no obstacle, as soon as a frame has it. */
    public void selectSensorWhenPresent(String id) {
        select(Set.of());
        context.model().selectSensorWhenPresent(id);
    }

    /** Returns the id of the selected sensor; empty if there is none. */
    public Optional<String> selectedSensor() {
        return context.model().sensor().get();
    }

    /** Returns the direction of a position on the canvas from the robot's centre, radians from straight ahead. */
    public OptionalDouble directionOf(Point at) {
        Vector2 point = context.viewport().camera().get().toWorld(new Vector2(at.x, at.y));
        return context.model().frame().stream()
                .mapToDouble(frame -> frame.snapshot().pose().toLocal(point).angle())
                .findFirst();
    }

    /** Prepares for another scenario: nothing is dragged, drawn or selected, and its first frame is fitted. */
    public void startScenario() {
        mouse.startScenario();
        context.viewport().startScenario();
        clearSelection();
    }

    /** Selects no obstacle and no sensor. */
    public void clearSelection() {
        assert EventQueue.isDispatchThread();
        context.model().select(Set.of());
        context.model().selectSensorWhenPresent("");
        context.model().sensor().set(Optional.empty());
    }

    /** Adds a listener that is called with the id of the selected sensor, empty for none, when it changes. */
    public void addSensorListener(Consumer<Optional<String>> listener) {
        context.model().sensor().addListener(listener);
    }

    /** Returns the listeners for notes, menus and start poses. */
    public CanvasListeners listeners() {
        return context.listeners();
    }
}
