package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;

/**
 * A problem with a file.
 *
 * @param file the file as the user named it
 * @param location the location in the file, {@link SourceLocation#NONE} for the whole file
 * @param message the error, the given value, and the allowed values
 */
public record Problem(String file, SourceLocation location, Message message) {

    /** Returns one line: {@code file:line:column: message}, or {@code file: message} without a location. */
    @Override
    public String toString() {
        return MessageText.oneLine(file + location + ": " + message);
    }
}
