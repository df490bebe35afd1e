package faultline.gui.canvas.tool;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.IdGenerator;
import faultline.gui.edit.PointShapes;
import faultline.gui.edit.ShapePreset;
import faultline.gui.edit.SnapSettings;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WaypointPath;
import java.awt.EventQueue;
import java.awt.Point;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JComponent;

/**
 * What the hand does with a canvas beyond looking: its tools, its snapping, what is selected, and who is told. Event
 * dispatch thread only.
 */
public final class CanvasTools {

    /** How fast an obstacle moves that is given way-points, metres per second. */
    private static final double DEFAULT_SPEED = 0.2;

    private final ToolContext context;
    private final CanvasMouse mouse;
    private final JComponent canvas;

    public CanvasTools(ToolContext desk, CanvasMouse hand, JComponent canvas) {
        this.context = desk;
        this.mouse = hand;
        this.canvas = canvas;
    }

    /**
     * Lets the left button place a shape, once.
     *
     * @param shape what is placed
     */
    public void placeShape(ShapePreset shape) {
        activate(new PlaceTool(shape, context));
    }

    /** Lets the left button draw a wall from point to point. */
    public void drawWall() {
        activate(new PointsTool(
                context, 2, false, points -> context.placeObstacle(PointShapes.wall(newId("wall"), points))));
    }

    /** Lets the left button draw a polygon from corner to corner, or free hand. */
    public void drawPolygon() {
        activate(new PointsTool(
                context, 3, true, points -> context.placeObstacle(PointShapes.polygon(newId("polygon"), points))));
    }

    /**
     * Lets the left button give the selected obstacle a way from where it stands; nothing happens where none or several
     * are selected.
     */
    public void drawMotionPath() {
        context.model()
                .singleSelected()
                .ifPresent(obstacle ->
                        activate(new PointsTool(context, 1, true, points -> setMotionPath(obstacle.id(), points))));
    }

    /** Lets the left button measure distances and angles until it is told to stop; nothing is changed. */
    public void measure() {
        activate(new MeasureTool());
    }

    private boolean setMotionPath(String id, List<Vector2> points) {
        context.model().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst()
                .ifPresent(obstacle -> {
                    List<Vector2> way = new ArrayList<>(points);
                    way.add(obstacle.pose().position());
                    double speed = obstacle.isMoving() ? obstacle.motion().speed() : DEFAULT_SPEED;
                    WaypointPath motion = new WaypointPath(speed, true, way);
                    context.editor().send(new Command.PlaceObstacle(obstacle.withMotion(motion)));
                });
        return true;
    }

    private String newId(String stem) {
        return IdGenerator.uniqueId(stem, context.model().obstacleIds());
    }

    private void activate(Tool tool) {
        assert EventQueue.isDispatchThread();
        mouse.cancel();
        mouse.tool().set(Optional.of(tool));
        canvas.requestFocusInWindow();
        canvas.repaint();
    }

    /**
     * Tells a listener, from now on, whether a tool is in use whenever that changes.
     *
     * @param listener gets true while the left button neither selects nor moves
     */
    public void addToolListener(Consumer<Boolean> listener) {
        mouse.tool().addListener(tool -> listener.accept(tool.isPresent()));
    }

    /**
     * Sets what the hand's places and angles are rounded to while Alt is not down.
     *
     * @param snap the steps
     */
    public void setSnap(SnapSettings snap) {
        mouse.setSnap(snap);
    }

    /**
     * The ids of all obstacles.
     *
     * @return of the frame that shows
     */
    public Set<String> ids() {
        return context.model().obstacleIds();
    }

    /**
     * The obstacles that are selected.
     *
     * @return as they stand in the frame that shows, in drawing order
     */
    public List<Obstacle> selected() {
        return context.model().selected();
    }

    /**
     * Selects obstacles and no others.
     *
     * @param ids their ids; those that are not there are left out
     */
    public void select(Collection<String> ids) {
        assert EventQueue.isDispatchThread();
        context.model().select(ids);
    }

    /** Selects all obstacles. */
    public void selectAll() {
        select(context.model().obstacles().stream().map(Obstacle::id).toList());
    }

    /**
     * Selects obstacles that are about to be put, as soon as they are all there.
     *
     * @param ids their ids
     */
    public void selectWhenPresent(Collection<String> ids) {
        context.model().selectWhenPresent(ids);
    }

    /**
     * Tells a listener, from now on, which obstacles are selected whenever that changes.
     *
     * @param listener gets their ids
     */
    public void addSelectionListener(Consumer<Set<String>> listener) {
        context.model().selection().addListener(listener);
    }

    /**
     * Selects a sensor or none.
     *
     * @param sensor its id, empty for none
     */
    public void selectSensor(Optional<String> sensor) {
        assert EventQueue.isDispatchThread();
        context.model()
                .sensor()
                .set(sensor.filter(id -> context.model().sensor(id).isPresent()));
    }

    /**
     * Tells a listener, from now on, which sensor is selected whenever that changes.
     *
     * @param listener gets its id, empty where none is selected
     */
    public void addSensorListener(Consumer<Optional<String>> listener) {
        context.model().sensor().addListener(listener);
    }

    /**
     * Tells a listener, from now on, why something was not done.
     *
     * @param listener gets one sentence
     */
    public void addNoteListener(Consumer<String> listener) {
        context.listeners().addNoteListener(listener);
    }

    /**
     * Tells a listener, from now on, when a menu is wanted.
     *
     * @param listener gets the place on the canvas
     */
    public void addMenuListener(Consumer<Point> listener) {
        context.listeners().addMenuListener(listener);
    }

    /**
     * Lets the hand take the robot while time has not begun, and tells a listener, from now on, where it is to start.
     *
     * @param listener gets the pose, where there is room for the robot
     */
    public void addStartListener(Consumer<Pose> listener) {
        context.listeners().addStartListener(listener);
    }
}
