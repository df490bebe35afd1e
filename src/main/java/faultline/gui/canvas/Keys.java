package faultline.gui.canvas;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.ObstacleOutlines;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/**
 * What the keyboard does while the canvas has the focus: arrows nudge the selected obstacles, Q and E turn them, Enter ends a tool, Esc
 * lets go.
 */
final class Keys {

    private static final double NUDGE = 0.01;
    private static final double BIG_NUDGE = 0.1;
    private static final double TURN = Degrees.toRadians(5);

    private final Scene scene;
    private final Courier courier;
    private final Hand hand;

    Keys(Scene scene, Courier courier, Hand hand) {
        this.scene = scene;
        this.courier = courier;
        this.hand = hand;
    }

    void install(JComponent canvas) {
        nudges(canvas, "LEFT", -1, 0);
        nudges(canvas, "RIGHT", 1, 0);
        nudges(canvas, "UP", 0, 1);
        nudges(canvas, "DOWN", 0, -1);
        bind(canvas, "Q", () -> turn(TURN));
        bind(canvas, "E", () -> turn(-TURN));
        bind(canvas, "ENTER", () -> withTool(Tool::finish));
        bind(canvas, "BACK_SPACE", () -> withTool(Tool::back));
        bind(canvas, "shift F10", hand::askForMenu);
        bind(canvas, "CONTEXT_MENU", hand::askForMenu);
        bind(canvas, "ESCAPE", this::letGo);
    }

    private void nudges(JComponent canvas, String key, int right, int up) {
        bind(canvas, key, () -> nudge(right * NUDGE, up * NUDGE));
        bind(canvas, "shift " + key, () -> nudge(right * BIG_NUDGE, up * BIG_NUDGE));
    }

    private void nudge(double dx, double dy) {
        change(obstacle -> new Pose(obstacle.pose().x() + dx, obstacle.pose().y() + dy, obstacle.pose().heading()));
    }

    private void turn(double turn) {
        List<Obstacle> expected = scene.selected().stream().map(courier::expected).toList();
        if (!expected.isEmpty()) {
            Vec middle = ObstacleOutlines.middle(expected);
            change(obstacle -> ObstacleOutlines.turned(obstacle, middle, turn));
        }
    }

    private void change(Function<Obstacle, Pose> change) {
        courier.send(scene.selected().stream()
                .<Command>map(obstacle -> new Command.MoveObstacle(obstacle.id(), change.apply(courier.expected(obstacle)))).toList());
    }

    private void withTool(Consumer<Tool> deed) {
        hand.tool().get().ifPresent(deed);
        hand.endTool();
    }

    private void letGo() {
        if (!hand.cancel()) {
            scene.select(Set.of());
            scene.sensor().set(Optional.empty());
        }
    }

    private static void bind(JComponent canvas, String key, Runnable action) {
        canvas.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), key);
        canvas.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
                canvas.repaint();
            }
        });
    }
}
