package faultline.engine.session;

import faultline.control.ControllerSpec;
import faultline.engine.Frame;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.recording.Recording;

/** Frames of runs that are not measured, for tests of what shows them. */
public final class SampleSessionFrames {

    private SampleSessionFrames() {}

    /** Returns a frame of a run with the default tick. */
    public static SessionFrame unmeasured(Frame frame, Recording recording) {
        return new SessionFrame(
                frame, recording, RunMeasures.NONE, new ControllerSpec.None(), "", SimulationSetup.DEFAULT_TICK);
    }
}
