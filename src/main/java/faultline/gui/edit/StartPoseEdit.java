package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.gui.text.Messages;
import java.util.function.Consumer;

/**
 * A new start pose of the robot; undoing it restarts the run.
 *
 * @param before the old start pose
 * @param after the new start pose
 * @param restarter restarts the run at a pose
 */
record StartPoseEdit(Pose before, Pose after, Consumer<Pose> restarter) implements Edit {

    @Override
    public String name() {
        return Messages.get("edit.start");
    }
}
