package faultline.floorplan;

import java.io.IOException;

/**
 * Thrown if a map cannot be read. The message is one sentence with the file, the location, the value and the allowed
 * values.
 */
public final class FloorPlanException extends IOException {

    /**
     * Creates an exception.
     *
     * @param message one sentence for the user
     */
    public FloorPlanException(String message) {
        super(message);
    }
}
