package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;

/**
 * What tools work on.
 *
 * @param scene what is there
 * @param viewpoint how it is looked at
 * @param editor where what they make goes
 * @param watchers told what was not done
 */
record Desk(Scene scene, Viewpoint viewpoint, Editor editor, Watchers watchers) {

    /** Puts an obstacle where there is room for it, and selects it; says whether there was. */
    boolean put(Obstacle obstacle) {
        if (Room.isBlocked(scene, obstacle)) {
            note(Texts.text("refused.robot", obstacle.id()));
            return false;
        }
        scene.await(List.of(obstacle.id()));
        editor.send(new Command.PutObstacle(obstacle));
        return true;
    }

    void note(String sentence) {
        watchers.note(sentence);
    }

    /** How far apart two points of the world are in the picture. */
    double pixels(Vec from, Vec to) {
        return from.distanceTo(to) * viewpoint.camera().get().scale();
    }

    /** Whether a hand that went from one to another has meant to. */
    boolean isFar(Vec from, Vec to) {
        return pixels(from, to) >= Hold.CLICK;
    }
}
