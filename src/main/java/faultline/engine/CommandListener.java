package faultline.engine;

import faultline.world.Command;
import java.util.Optional;

/**
 * Told of every command that a simulation is given, by its timeline or from outside, on the run's own thread; it must
 * change nothing.
 */
@FunctionalInterface
public interface CommandListener {

    /** Listens to nothing. */
    CommandListener NONE = (tick, command, refusal) -> {};

    /**
     * A command was given at the start of a tick.
     *
     * @param tick the tick
     * @param command what was to be done
     * @param refusal why it was refused, empty where it was done
     */
    void commandHandled(long tick, Command command, Optional<String> refusal);
}
