package faultline.gui.canvas.tool;

import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;

/**
 * The effect of a drag at a position of the mouse: commands, changed obstacles, and the changed value in the user's
 * language.
 */
public record DragPreview(List<Command> commands, List<Obstacle> obstacles, String valueText) {

    public DragPreview {
        commands = List.copyOf(commands);
        obstacles = List.copyOf(obstacles);
    }
}
