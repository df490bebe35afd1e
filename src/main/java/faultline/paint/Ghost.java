package faultline.paint;

import faultline.engine.RecordedRun;
import faultline.geometry.Pose;
import java.util.List;
import java.util.OptionalLong;

/**
 * An earlier run that shows beside the one in the frame.
 *
 * @param run where its robot was
 * @param dt the length of its ticks, seconds
 * @param divergence the first tick in which the two differ, empty while they do not
 * @param caption what it is and how it compares, a line each, for the picture's corner
 * @param mark what stands beside the place of the divergence
 */
public record Ghost(RecordedRun run, double dt, OptionalLong divergence, List<String> caption, String mark) {

    public Ghost {
        caption = List.copyOf(caption);
    }

    /** Where its robot was at a time, seconds. */
    Pose at(double time) {
        return run.pose(Math.round(time / dt));
    }
}
