package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.CommandSender;
import faultline.gui.text.Messages;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;

/** The objects that tools work on. */
public record ToolContext(CanvasModel model, Viewport viewport, CommandSender sender, CanvasListeners listeners) {

    /** Places and selects an obstacle if there is room for it; returns whether there is. */
    public boolean placeObstacle(Obstacle obstacle) {
        if (PlacementCheck.overlapsRobot(model, obstacle)) {
            listeners.fireNote(
                    Messages.get("refused.robot", obstacle.id()),
                    world -> PlacementCheck.overlapsRobot(world, obstacle)
                            && world.obstacles().stream()
                                    .noneMatch(placed -> placed.id().equals(obstacle.id())));
            return false;
        }
        model.selectWhenPresent(List.of(obstacle.id()));
        sender.send(new Command.PlaceObstacle(obstacle));
        return true;
    }

    /** Returns the selected obstacles as they will be after the commands that were sent, in drawing order. */
    List<Obstacle> expectedSelection() {
        return sender.pendingEdits().expected(model.selected());
    }

    void showNote(String sentence) {
        listeners.fireNote(sentence, world -> true);
    }

    /** Returns the distance between two points of the world on the canvas, pixels. */
    double pixelDistance(Vector2 from, Vector2 to) {
        return from.distanceTo(to) * viewport.camera().get().scale();
    }

    /** Returns whether a move between two points of the world is more than the jitter of a click. */
    boolean isBeyondClickTolerance(Vector2 from, Vector2 to) {
        return pixelDistance(from, to) >= Gesture.CLICK_TOLERANCE;
    }
}
