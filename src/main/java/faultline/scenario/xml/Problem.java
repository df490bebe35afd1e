package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;

/**
 * One thing that is wrong with a file, in one line.
 *
 * @param file as the user named it
 * @param location where in the file, {@link SourceLocation#NONE} where it is the whole file
 * @param message what is wrong, the value given, what is allowed
 */
public record Problem(String file, SourceLocation location, Message message) {

    /**
     * The line for a user.
     *
     * @return {@code file:line:column: what}, or {@code file: what} without a place
     */
    @Override
    public String toString() {
        return MessageText.oneLine(file + location + ": " + message);
    }
}
