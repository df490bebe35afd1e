package faultline.paint.scene;

import faultline.engine.session.ReferenceRun;
import faultline.geometry.Pose;
import java.util.List;

/**
 * A reference run, shown beside the run in the frame.
 *
 * @param run its path
 * @param caption its description and the comparison, line by line, for the corner of the picture
 * @param marks the moments to mark on the path
 */
public record ReferenceOverlay(ReferenceRun run, List<String> caption, List<Mark> marks) {

    /** A text on the path, at the position at the end of a tick. */
    public record Mark(long tick, String label) {}

    public ReferenceOverlay {
        caption = List.copyOf(caption);
        marks = List.copyOf(marks);
    }

    /** Returns the pose of its robot at a time, seconds. */
    Pose poseAt(double time) {
        return run.pose(Math.round(time / run.setup().dt()));
    }
}
