package faultline.engine.session;

import faultline.control.Telemetry;
import faultline.engine.Frame;
import faultline.engine.recording.Recording;
import faultline.world.Snapshot;

/**
 * A frame that a session publishes, with what has been recorded up to its tick. Immutable.
 *
 * @param frame the state at the end of a tick
 * @param recording the recording of the run up to that tick
 */
public record SessionFrame(Frame frame, Recording recording) {

    /** Returns the world at the end of the tick. */
    public Snapshot snapshot() {
        return frame.snapshot();
    }

    /** Returns the controller's telemetry of the tick. */
    public Telemetry telemetry() {
        return frame.telemetry();
    }
}
