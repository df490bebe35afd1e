package faultline.floorplan;

import faultline.io.Message;
import faultline.io.MessageException;
import faultline.io.MessageText;
import java.nio.file.Path;

/**
 * Thrown if a map cannot be read. The message is one sentence with the file, the location, the value and the allowed
 * values.
 */
public final class FloorPlanException extends MessageException {

    private static final long serialVersionUID = 1L;

    /**
     * Creates an exception for a file as a whole.
     *
     * @param file the map or image
     * @param reason the problem
     */
    public FloorPlanException(Path file, Message reason) {
        super(MessageText.oneLine(file.toString()), reason, null);
    }

    /**
     * Creates an exception for a place in a file.
     *
     * @param file the map
     * @param line the line, from 1
     * @param column the column, from 1
     * @param reason the problem
     */
    public FloorPlanException(Path file, int line, int column, Message reason) {
        super(MessageText.oneLine(file.toString()) + ":" + line + ":" + column, reason, null);
    }
}
