package faultline.io;

import java.io.IOException;
import java.nio.file.Path;

/** Reports why a file cannot be read or written, with a message that can be translated. */
public class MessageException extends IOException {

    private static final long serialVersionUID = 1L;

    /** The file that the reason is about, possibly with line and column, or an empty string. */
    private final String subject;

    private final transient Message reason;

    /**
     * Creates an exception.
     *
     * @param subject the file, possibly with line and column, which precedes the reason in the exception's message; may
     *     be empty
     * @param reason the reason
     * @param cause the cause, may be null
     */
    public MessageException(String subject, Message reason, Throwable cause) {
        super(subject.isEmpty() ? reason.toString() : subject + ": " + reason, cause);
        this.subject = subject;
        this.reason = reason;
    }

    /**
     * Describes a failure to write in one sentence.
     *
     * @param file the file as the user named it
     * @param cause the failure, as the operating system reports it
     * @return an exception with the name of the file and the reason
     */
    public static MessageException ofWriting(Path file, IOException cause) {
        WriteProblem reason = WriteProblem.of(file, String.valueOf(cause.getMessage()));
        return new MessageException(MessageText.oneLine(file.toString()), reason.with(), cause);
    }

    /** {@return the name of the file, possibly with line and column; may be empty} */
    public final String subject() {
        return subject;
    }

    /** {@return the reason without the name of the file} */
    public final Message reason() {
        return reason;
    }
}
