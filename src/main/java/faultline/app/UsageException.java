package faultline.app;

/** Arguments that make no sense. The message is one line for a user. */
final class UsageException extends Exception {

    private static final long serialVersionUID = 1L;

    UsageException(String message) {
        super(message);
    }
}
