package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.gui.edit.Editor;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Sends what a hand wants, and knows where obstacles were sent until the frames show them there. */
final class Courier {

    /** After so many frames an obstacle that was sent elsewhere is there, or never will be because the world refused. */
    private static final int PATIENCE = 10;

    private final Editor editor;
    private final Map<String, Pose> underway = new HashMap<>();
    private int framesSince;

    Courier(Editor editor) {
        this.editor = editor;
    }

    /** A hand has taken hold of something: all that it sends until it lets go is one edit. */
    void begin() {
        editor.begin();
    }

    void end() {
        editor.end();
    }

    void send(List<Command> commands) {
        if (!commands.isEmpty()) {
            framesSince = 0;
            commands.forEach(this::note);
            editor.send(commands);
        }
    }

    private void note(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            underway.put(move.obstacle(), move.pose());
        }
    }

    /** An obstacle where it will be once the world has done what it was told. */
    Obstacle expected(Obstacle obstacle) {
        return obstacle.at(underway.getOrDefault(obstacle.id(), obstacle.pose()));
    }

    /** Sees by a new frame what has arrived. */
    void frameShown(List<Obstacle> obstacles) {
        framesSince++;
        if (framesSince >= PATIENCE) {
            underway.clear();
        }
        obstacles.forEach(obstacle -> underway.remove(obstacle.id(), obstacle.pose()));
    }
}
