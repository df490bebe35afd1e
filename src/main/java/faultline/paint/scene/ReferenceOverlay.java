package faultline.paint.scene;

import faultline.engine.session.ReferenceRun;
import faultline.geometry.Pose;
import java.util.List;
import java.util.OptionalLong;

/**
 * A reference run, shown beside the run in the frame.
 *
 * @param run its path
 * @param dt the length of its ticks, seconds
 * @param divergenceTick the first tick in which the two runs differ, empty if they do not
 * @param caption its description and the comparison, line by line, for the corner of the picture
 * @param divergenceLabel beside the point at which they first differ
 */
public record ReferenceOverlay(
        ReferenceRun run, double dt, OptionalLong divergenceTick, List<String> caption, String divergenceLabel) {

    public ReferenceOverlay {
        caption = List.copyOf(caption);
    }

    /** Returns the pose of its robot at a time, seconds. */
    Pose poseAt(double time) {
        return run.pose(Math.round(time / dt));
    }
}
