package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.edit.FreshIds;
import faultline.gui.edit.PointShapes;
import faultline.gui.edit.ReadyShape;
import faultline.gui.edit.Snap;
import faultline.world.Command;
import faultline.world.Motion;
import faultline.world.Obstacle;
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
 * What the hand does with a canvas beyond looking: its tools, its snapping, what is selected, and who is told. Event dispatch thread only.
 */
public final class CanvasTools {

    /** How fast an obstacle moves that is given way-points, metres per second. */
    private static final double USUAL_SPEED = 0.2;

    private final Desk desk;
    private final Hand hand;
    private final JComponent canvas;

    CanvasTools(Desk desk, Hand hand, JComponent canvas) {
        this.desk = desk;
        this.hand = hand;
        this.canvas = canvas;
    }

    /**
     * Lets the left button place a shape, once.
     *
     * @param shape what is placed
     */
    public void place(ReadyShape shape) {
        use(new PlaceTool(shape, desk));
    }

    /** Lets the left button draw a wall from point to point. */
    public void drawWall() {
        use(new PointsTool(desk, 2, false, points -> desk.put(PointShapes.wall(fresh("wall"), points))));
    }

    /** Lets the left button draw a polygon from corner to corner, or free hand. */
    public void drawPolygon() {
        use(new PointsTool(desk, 3, true, points -> desk.put(PointShapes.polygon(fresh("polygon"), points))));
    }

    /** Lets the left button give the selected obstacle a way from where it stands; nothing happens where none or several are selected. */
    public void drawWay() {
        desk.scene().single().ifPresent(obstacle -> use(new PointsTool(desk, 1, true, points -> moveAlong(obstacle.id(), points))));
    }

    /** Lets the left button measure distances and angles until it is told to stop; nothing is changed. */
    public void measure() {
        use(new MeasureTool());
    }

    private boolean moveAlong(String id, List<Vec> points) {
        desk.scene().obstacles().stream().filter(obstacle -> obstacle.id().equals(id)).findFirst().ifPresent(obstacle -> {
            List<Vec> way = new ArrayList<>(points);
            way.add(obstacle.pose().position());
            Motion motion = new Motion(obstacle.motion().map(Motion::speed).orElse(USUAL_SPEED), true, way);
            desk.editor().send(new Command.PutObstacle(obstacle.moving(Optional.of(motion))));
        });
        return true;
    }

    private String fresh(String stem) {
        return FreshIds.like(stem, desk.scene().ids());
    }

    private void use(Tool tool) {
        assert EventQueue.isDispatchThread();
        hand.cancel();
        hand.tool().set(Optional.of(tool));
        canvas.requestFocusInWindow();
        canvas.repaint();
    }

    /**
     * Tells a listener, from now on, whether a tool is in use whenever that changes.
     *
     * @param listener gets true while the left button neither selects nor moves
     */
    public void addToolListener(Consumer<Boolean> listener) {
        hand.tool().listen(tool -> listener.accept(tool.isPresent()));
    }

    /**
     * Sets what the hand's places and angles are rounded to while Alt is not down.
     *
     * @param snap the steps
     */
    public void setSnap(Snap snap) {
        hand.setSnap(snap);
    }

    /**
     * The ids of all obstacles.
     *
     * @return of the frame that shows
     */
    public Set<String> ids() {
        return desk.scene().ids();
    }

    /**
     * The obstacles that are selected.
     *
     * @return as they stand in the frame that shows, in drawing order
     */
    public List<Obstacle> selected() {
        return desk.scene().selected();
    }

    /**
     * Selects obstacles and no others.
     *
     * @param ids their ids; those that are not there are left out
     */
    public void select(Collection<String> ids) {
        assert EventQueue.isDispatchThread();
        desk.scene().select(ids);
    }

    /** Selects all obstacles. */
    public void selectAll() {
        select(desk.scene().obstacles().stream().map(Obstacle::id).toList());
    }

    /**
     * Selects obstacles that are about to be put, as soon as they are all there.
     *
     * @param ids their ids
     */
    public void selectSoon(Collection<String> ids) {
        desk.scene().await(ids);
    }

    /**
     * Tells a listener, from now on, which obstacles are selected whenever that changes.
     *
     * @param listener gets their ids
     */
    public void addSelectionListener(Consumer<Set<String>> listener) {
        desk.scene().selection().listen(listener);
    }

    /**
     * Selects a sensor or none.
     *
     * @param sensor its id, empty for none
     */
    public void selectSensor(Optional<String> sensor) {
        assert EventQueue.isDispatchThread();
        desk.scene().sensor().set(sensor.filter(id -> desk.scene().sensor(id).isPresent()));
    }

    /**
     * Tells a listener, from now on, which sensor is selected whenever that changes.
     *
     * @param listener gets its id, empty where none is selected
     */
    public void addSensorListener(Consumer<Optional<String>> listener) {
        desk.scene().sensor().listen(listener);
    }

    /**
     * Tells a listener, from now on, why something was not done.
     *
     * @param listener gets one sentence
     */
    public void addNoteListener(Consumer<String> listener) {
        desk.watchers().listenToNotes(listener);
    }

    /**
     * Tells a listener, from now on, when a menu is wanted.
     *
     * @param listener gets the place on the canvas
     */
    public void addMenuListener(Consumer<Point> listener) {
        desk.watchers().listenToMenus(listener);
    }

    /**
     * Lets the hand take the robot while time has not begun, and tells a listener, from now on, where it is to start.
     *
     * @param listener gets the pose, where there is room for the robot
     */
    public void addStartListener(Consumer<Pose> listener) {
        desk.watchers().listenToStarts(listener);
    }
}
