package faultline.engine;

import faultline.control.ControllerState;
import faultline.geometry.Pose;
import faultline.robot.WheelSpeeds;
import faultline.world.World;

/** Records the robot's path, and the hash over the state of every tick. */
final class TrajectoryRecorder {

    private final TrajectoryHash hash = new TrajectoryHash();
    private final PathRecorder path = new PathRecorder();
    private boolean recordsPath = true;

    void stopRecordingPath() {
        recordsPath = false;
    }

    /** Records the end of a tick. */
    void record(World world, ControllerState state) {
        Pose pose = world.pose();
        hash.add(pose.x());
        hash.add(pose.y());
        hash.add(pose.heading());
        WheelSpeeds speeds = world.wheelSpeeds();
        hash.add(speeds.left());
        hash.add(speeds.right());
        int sensors = world.robot().sensors().size();
        for (int i = 0; i < sensors; i++) {
            hash.add(world.reportedReading(i));
        }
        if (recordsPath) {
            path.record(pose.x(), pose.y(), PathTag.of(state, world));
        }
    }

    long hash() {
        return hash.value();
    }

    RobotPath path() {
        return path.view();
    }
}
