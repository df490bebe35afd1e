package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.gui.edit.Editor;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.Optional;

/** Sends obstacles elsewhere, each place once, and knows where the last one was sent until the frames show it there. */
final class ObstacleMover {

    /** After so many frames an obstacle that was sent elsewhere is there, or never will be because the world refused. */
    private static final int PATIENCE = 10;

    private final Editor editor;
    private Optional<Command.MoveObstacle> underway = Optional.empty();
    private int framesSince;

    ObstacleMover(Editor editor) {
        this.editor = editor;
    }

    /** A hand has taken hold of an obstacle: all that it sends until it lets go is one edit. */
    void begin() {
        editor.begin();
    }

    void end() {
        editor.end();
    }

    /** Sends an obstacle to a pose, unless it is on its way there. */
    void send(String obstacle, Pose pose) {
        Command.MoveObstacle move = new Command.MoveObstacle(obstacle, pose);
        if (!underway.equals(Optional.of(move))) {
            underway = Optional.of(move);
            framesSince = 0;
            editor.send(move);
        }
    }

    /** Where an obstacle will be once the world has done what it was told. */
    Pose expected(Obstacle obstacle) {
        return underway.filter(move -> move.obstacle().equals(obstacle.id())).map(Command.MoveObstacle::pose).orElse(obstacle.pose());
    }

    /** Counts a new frame. */
    void frameShown() {
        framesSince++;
        if (framesSince >= PATIENCE) {
            underway = Optional.empty();
        }
    }
}
