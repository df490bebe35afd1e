package faultline.engine;

/** A run that cannot go on: its controller threw, or does not answer. The message is one sentence for a user. */
public class RunFailedException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    /**
     * A failure with its cause.
     *
     * @param message one sentence for a user
     * @param cause what was thrown, or null
     */
    public RunFailedException(String message, Throwable cause) {
        super(message, cause);
    }
}
