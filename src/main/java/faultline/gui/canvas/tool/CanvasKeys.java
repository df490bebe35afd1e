package faultline.gui.canvas.tool;

import faultline.geometry.Angles;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.Rounding;
import faultline.gui.theme.KeyBindings;
import faultline.paint.scene.ObstacleOutlines;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JComponent;

/**
 * Handles the keys of the focused canvas: arrows nudge the selected obstacles, or move the point of the active tool, or
 * else the view; Q and E rotate obstacles or turn the selected sensor, Insert sets a point of a tool, Enter completes
 * it. Escape cancels, and so does the key of undo during a gesture. Keys that move or turn have no effect during a
 * gesture, which would undo them with its next movement.
 */
public final class CanvasKeys {

    private static final double SMALL_NUDGE = 0.01;
    private static final double BIG_NUDGE = 0.1;
    private static final double SMALL_PAN_PIXELS = 60;
    private static final double BIG_PAN_PIXELS = 300;
    private static final double TURN_ANGLE = Degrees.toRadians(5);

    private final ToolContext context;
    private final CanvasMouse mouse;

    public CanvasKeys(ToolContext context, CanvasMouse mouse) {
        this.context = context;
        this.mouse = mouse;
    }

    public void install(JComponent canvas) {
        bindNudges(canvas, "LEFT", -1, 0);
        bindNudges(canvas, "RIGHT", 1, 0);
        bindNudges(canvas, "UP", 0, 1);
        bindNudges(canvas, "DOWN", 0, -1);
        bind(canvas, "Q", unlessDragging(() -> turn(TURN_ANGLE)));
        bind(canvas, "E", unlessDragging(() -> turn(-TURN_ANGLE)));
        bind(canvas, "INSERT", mouse::clickKeyPoint);
        bind(canvas, "ENTER", () -> withTool(tool -> tool.confirm(mouse.keyPoint())));
        bind(canvas, "BACK_SPACE", () -> withTool(Tool::removeLastPoint));
        bind(canvas, "shift F10", mouse::requestMenu);
        bind(canvas, "CONTEXT_MENU", mouse::requestMenu);
        bind(canvas, "ESCAPE", this::cancelOrDeselect);
        // Undo in the middle of a gesture cancels it instead of undoing an edit.
        bind(canvas, "menu Z", mouse::isGestureActive, mouse::cancelGesture);
    }

    private void bindNudges(JComponent canvas, String key, int right, int up) {
        bind(canvas, key, unlessDragging(() -> nudge(right * SMALL_NUDGE, up * SMALL_NUDGE, SMALL_PAN_PIXELS)));
        bind(canvas, "shift " + key, unlessDragging(() -> nudge(right * BIG_NUDGE, up * BIG_NUDGE, BIG_PAN_PIXELS)));
    }

    private Runnable unlessDragging(Runnable action) {
        return () -> {
            if (!mouse.isGestureActive()) {
                action.run();
            }
        };
    }

    private void nudge(double dx, double dy, double pixels) {
        Vector2 step = new Vector2(dx, dy);
        if (mouse.tool().get().isPresent() || context.model().selected().isEmpty()) {
            mouse.moveKeyPoint(step, pixels);
            return;
        }
        moveSelected(obstacle ->
                obstacle.pose().withPosition(obstacle.pose().position().plus(step)));
    }

    private void turn(double turn) {
        List<Obstacle> expected = context.expectedSelection();
        if (expected.isEmpty()) {
            turnSensor(turn);
        } else {
            Vector2 middle = ObstacleOutlines.centre(expected);
            moveSelected(obstacle -> ObstacleOutlines.rotatedPose(obstacle, middle, turn));
        }
    }

    private void turnSensor(double turn) {
        context.model()
                .sensor()
                .get()
                .flatMap(id -> context.sender().pendingEdits().robot().sensor(id))
                .map(sensor -> sensor.withBearing(Rounding.roundAngle(Angles.normalize(sensor.bearing() + turn))))
                .ifPresent(turned -> context.sender().send(new Command.ConfigureSensor(turned)));
    }

    private void moveSelected(Function<Obstacle, Pose> change) {
        context.sender()
                .send(context.expectedSelection().stream()
                        .<Command>map(obstacle -> new Command.MoveObstacle(obstacle.id(), moved(obstacle, change)))
                        .toList());
    }

    private static Pose moved(Obstacle obstacle, Function<Obstacle, Pose> change) {
        return Rounding.round(obstacle.pose(), change.apply(obstacle));
    }

    private void withTool(Consumer<Tool> action) {
        mouse.tool().get().ifPresent(action);
        mouse.clearFinishedTool();
    }

    private void cancelOrDeselect() {
        if (!mouse.cancel()) {
            context.model().select(Set.of());
            context.model().sensor().set(Optional.empty());
        }
    }

    private static void bind(JComponent canvas, String key, Runnable action) {
        bind(canvas, key, () -> true, action);
    }

    private static void bind(JComponent canvas, String key, BooleanSupplier condition, Runnable action) {
        KeyBindings.bind(canvas, key, condition, () -> {
            action.run();
            canvas.repaint();
        });
    }
}
