package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;

/**
 * What tools work on.
 *
 * @param model what is there
 * @param viewport how it is looked at
 * @param editor sends commands
 * @param listeners told what was not done
 */
public record ToolContext(CanvasModel model, Viewport viewport, UndoController editor, CanvasListeners listeners) {

    /** Puts an obstacle where there is room for it, and selects it; says whether there was. */
    public boolean placeObstacle(Obstacle obstacle) {
        if (PlacementCheck.overlapsRobot(model, obstacle)) {
            showNote(Messages.get("refused.robot", obstacle.id()));
            return false;
        }
        model.selectWhenPresent(List.of(obstacle.id()));
        editor.send(new Command.PlaceObstacle(obstacle));
        return true;
    }

    void showNote(String sentence) {
        listeners.fireNote(sentence);
    }

    /** How far apart two points of the world are in the picture. */
    double pixelDistance(Vector2 from, Vector2 to) {
        return from.distanceTo(to) * viewport.camera().get().scale();
    }

    /** Whether a hand that went from one to another has meant to. */
    boolean isBeyondClickTolerance(Vector2 from, Vector2 to) {
        return pixelDistance(from, to) >= Gesture.CLICK_TOLERANCE;
    }
}
