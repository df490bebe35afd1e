package faultline.paint.scene;

import faultline.engine.session.ReferenceRun;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import java.util.List;

/**
 * A reference run, shown beside the run in the frame, with moments marked on its path and lines of text for the corner
 * of the picture, at least one, whose first ends with the name of the run.
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
        return run.pose(tickAt(time));
    }

    /** Returns its robot, which may have changed since the start, at a time, seconds. */
    RobotSpec robotAt(double time) {
        return run.robot(tickAt(time));
    }

    private long tickAt(double time) {
        return Math.round(time / run.setup().dt());
    }
}
