package faultline.engine;

import faultline.world.CommandResult;

/**
 * Receives the result of every command that a simulation executes or refuses, from its timeline or from outside, on the
 * run's own thread. A command of the timeline about an obstacle that a command from outside has removed is void and has
 * no result. The listener must not change the simulation.
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
