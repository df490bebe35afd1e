package faultline.gui.edit;

import faultline.world.Command;
import java.util.List;

/** Takes what a user does to the world. Event dispatch thread only. */
@FunctionalInterface
public interface CommandSink {

    /**
     * Gives a command.
     *
     * @param command what is to be done
     */
    void send(Command command);

    /**
     * Gives several commands that are one edit.
     *
     * @param commands what is to be done, in order
     */
    default void send(List<Command> commands) {
        commands.forEach(this::send);
    }

    /** A hand has taken hold of something: whatever it does until it lets go is one edit. */
    default void beginGesture() {}

    /** The hand has let go. */
    default void endGesture() {}
}
