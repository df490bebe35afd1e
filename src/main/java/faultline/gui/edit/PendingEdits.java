package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Sends what a hand wants, and knows where obstacles were sent until the frames show them there. */
public final class PendingEdits {

    /**
     * After so many frames an obstacle that was sent elsewhere is there, or never will be because the world refused.
     */
    private static final int MAX_FRAMES = 10;

    private final CommandSink commandSink;
    private final Map<String, Pose> pendingPoses = new HashMap<>();
    private int framesSince;

    public PendingEdits(CommandSink editor) {
        this.commandSink = editor;
    }

    /** A hand has taken hold of something: all that it sends until it lets go is one edit. */
    public void beginGesture() {
        commandSink.beginGesture();
    }

    public void endGesture() {
        commandSink.endGesture();
    }

    public void send(List<Command> commands) {
        if (!commands.isEmpty()) {
            framesSince = 0;
            commands.forEach(this::track);
            commandSink.send(commands);
        }
    }

    private void track(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            pendingPoses.put(move.obstacle(), move.pose());
        }
    }

    /** An obstacle where it will be once the world has done what it was told. */
    public Obstacle expectedObstacle(Obstacle obstacle) {
        return obstacle.withPose(pendingPoses.getOrDefault(obstacle.id(), obstacle.pose()));
    }

    /** Sees by a new frame what has arrived. */
    public void frameChanged(List<Obstacle> obstacles) {
        framesSince++;
        if (framesSince >= MAX_FRAMES) {
            pendingPoses.clear();
        }
        obstacles.forEach(obstacle -> pendingPoses.remove(obstacle.id(), obstacle.pose()));
    }
}
