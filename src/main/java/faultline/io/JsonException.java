package faultline.io;

/** Thrown if a text is not JSON; the message states the error and the index of the character. */
public final class JsonException extends Exception {

    private static final long serialVersionUID = 1L;

    JsonException(String message, int offset) {
        super(message + " at character " + (offset + 1));
    }
}
