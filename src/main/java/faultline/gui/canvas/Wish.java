package faultline.gui.canvas;

import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;

/**
 * What a hand wants.
 *
 * @param commands that would bring it about
 * @param there the obstacles as they would be; empty where the wish is about something else
 * @param values what the hand is changing, in words
 */
record Wish(List<Command> commands, List<Obstacle> there, String values) {

    Wish {
        commands = List.copyOf(commands);
        there = List.copyOf(there);
    }
}
