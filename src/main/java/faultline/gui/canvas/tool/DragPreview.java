package faultline.gui.canvas.tool;

import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;

/**
 * What a hand wants.
 *
 * @param commands that would bring it about
 * @param obstacles the obstacles as they would be; empty where the wish is about something else
 * @param valueText what the hand is changing, in words
 */
public record DragPreview(List<Command> commands, List<Obstacle> obstacles, String valueText) {

    public DragPreview {
        commands = List.copyOf(commands);
        obstacles = List.copyOf(obstacles);
    }
}
