package faultline.io;

/** A text that is no JSON; the message says what is wrong and at which character. */
public final class JsonException extends Exception {

    private static final long serialVersionUID = 1L;

    JsonException(String message, int offset) {
        super(message + " at character " + (offset + 1));
    }
}
