package faultline.engine;

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
}
