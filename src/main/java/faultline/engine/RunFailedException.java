package faultline.engine;

import faultline.control.RecordEndedException;

/**
 * Thrown if a run cannot continue: its controller threw an exception or does not answer. The message is one sentence
 * for the user.
 */
public class RunFailedException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    /**
     * Creates an exception.
     *
     * @param message one sentence for the user
     * @param cause the cause, or null
     */
    public RunFailedException(String message, Throwable cause) {
        super(message, cause);
    }

    /** Returns the exception for a run whose controller threw another one at a tick. */
    static RunFailedException ofController(long tick, Throwable cause) {
        if (cause instanceof RunFailedException failed) {
            return failed;
        }
        return new RunFailedException(
                cause instanceof RecordEndedException
                        ? cause.getMessage()
                        : "the controller broke at tick " + tick + ": " + cause,
                cause);
    }
}
