package faultline.floorplan;

import java.io.IOException;

/** A map that cannot be read; the message is one sentence with the file, the place, the value and what is allowed. */
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
