package faultline.app;

import faultline.io.MessageText;

/** Thrown if arguments are invalid. The message is one line for the user. */
class UsageException extends Exception {

    private static final long serialVersionUID = 1L;

    /** Returns the exception for a value that an option cannot have. */
    static UsageException ofValue(String option, String given, String expected) {
        return new UsageException(option + " is " + MessageText.quoted(given) + "; expected " + expected);
    }

    UsageException(String message) {
        super(message);
    }
}
