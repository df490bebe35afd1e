package faultline.engine;

import faultline.world.CommandResult;

/**
 * Receives the result of every command that a simulation executes or refuses, from its timeline or from outside, on the
 * run's own thread. It must not change the simulation.
 */
@FunctionalInterface
public interface CommandListener {

    /** Ignores all results. */
    CommandListener NONE = result -> {};

    /**
     * Called after a command was executed or refused at the start of a tick.
     *
     * @param result the result
     */
    void commandHandled(CommandResult result);
}
