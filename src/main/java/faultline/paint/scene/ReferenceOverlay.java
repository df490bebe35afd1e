package faultline.paint.scene;

import faultline.engine.session.ReferenceRun;
import faultline.geometry.Pose;
import java.util.List;
import java.util.OptionalLong;

/**
 * An earlier run that shows beside the one in the frame.
 *
 * @param run where its robot was
 * @param dt the length of its ticks, seconds
 * @param divergenceTick the first tick in which the two differ, empty while they do not
 * @param caption what it is and how it compares, a line each, for the picture's corner
 * @param divergenceLabel what stands beside the place of the divergence
 */
public record ReferenceOverlay(
        ReferenceRun run, double dt, OptionalLong divergenceTick, List<String> caption, String divergenceLabel) {

    public ReferenceOverlay {
        caption = List.copyOf(caption);
    }

    /** Where its robot was at a time, seconds. */
    Pose poseAt(double time) {
        return run.pose(Math.round(time / dt));
    }
}
