package faultline.gui.canvas;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.paint.ObstacleOutlines;
import faultline.world.Obstacle;
import java.awt.event.ActionEvent;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** What the keyboard does while the canvas has the focus: arrows nudge the selected obstacle, Q and E turn it, Esc lets go. */
final class Keys {

    private static final double NUDGE = 0.01;
    private static final double BIG_NUDGE = 0.1;
    private static final double TURN = Degrees.toRadians(5);

    private final Scene scene;
    private final ObstacleMover mover;
    private final Hand hand;

    Keys(Scene scene, ObstacleMover mover, Hand hand) {
        this.scene = scene;
        this.mover = mover;
        this.hand = hand;
    }

    void install(JComponent canvas) {
        nudges(canvas, "LEFT", -1, 0);
        nudges(canvas, "RIGHT", 1, 0);
        nudges(canvas, "UP", 0, 1);
        nudges(canvas, "DOWN", 0, -1);
        bind(canvas, "Q", () -> change(obstacle -> ObstacleOutlines.turned(obstacle, TURN)));
        bind(canvas, "E", () -> change(obstacle -> ObstacleOutlines.turned(obstacle, -TURN)));
        bind(canvas, "ESCAPE", this::letGo);
    }

    private void nudges(JComponent canvas, String key, int right, int up) {
        bind(canvas, key, () -> nudge(right * NUDGE, up * NUDGE));
        bind(canvas, "shift " + key, () -> nudge(right * BIG_NUDGE, up * BIG_NUDGE));
    }

    private void nudge(double dx, double dy) {
        change(obstacle -> new Pose(obstacle.pose().x() + dx, obstacle.pose().y() + dy, obstacle.pose().heading()));
    }

    private void change(Function<Obstacle, Pose> change) {
        scene.selected().ifPresent(obstacle -> mover.send(obstacle.id(), change.apply(obstacle.at(mover.expected(obstacle)))));
    }

    private void letGo() {
        if (!hand.cancel()) {
            scene.selection().set(Optional.empty());
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
