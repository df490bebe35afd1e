package faultline.io;

import java.io.IOException;

/** Reports why a file cannot be written, with a message that can be translated. */
public final class MessageException extends IOException {

    private static final long serialVersionUID = 1L;

    /** The file that the reason is about, or an empty string. */
    private final String subject;

    private final transient Message reason;

    /**
     * Creates an exception.
     *
     * @param subject the file, which precedes the reason in the exception's message; may be empty
     * @param reason the reason
     * @param cause the cause, may be null
     */
    public MessageException(String subject, Message reason, Throwable cause) {
        super(subject.isEmpty() ? reason.toString() : subject + ": " + reason, cause);
        this.subject = subject;
        this.reason = reason;
    }

    /** {@return the name of the file; may be empty} */
    public String subject() {
        return subject;
    }

    /** {@return the reason without the name of the file} */
    public Message reason() {
        return reason;
    }
}
