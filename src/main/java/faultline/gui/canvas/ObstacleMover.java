package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.Optional;
import java.util.function.Consumer;

/** Sends obstacles elsewhere, each place once, and knows where the last one was sent until the frames show it there. */
final class ObstacleMover {

    /** After so many frames an obstacle that was sent elsewhere is there, or never will be because the world refused. */
    private static final int PATIENCE = 10;

    private final Consumer<Command> commands;
    private Optional<Command.MoveObstacle> underway = Optional.empty();
    private int framesSince;

    ObstacleMover(Consumer<Command> commands) {
        this.commands = commands;
    }

    /** Sends an obstacle to a pose, unless it is on its way there. */
    void send(String obstacle, Pose pose) {
        Command.MoveObstacle move = new Command.MoveObstacle(obstacle, pose);
        if (!underway.equals(Optional.of(move))) {
            underway = Optional.of(move);
            framesSince = 0;
            commands.accept(move);
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
