package faultline.engine;

import faultline.control.ControllerState;
import faultline.geometry.Pose;
import faultline.robot.WheelSpeeds;
import faultline.world.World;

/** Records the robot's path, and the hash over the state of every tick. */
final class TrajectoryRecorder {

    private static final long MULTIPLIER = 0x9E3779B97F4A7C15L;

    private long hash = 0xCBF29CE484222325L;
    private final PathRecorder path = new PathRecorder();
    private boolean recordsPath = true;

    void stopRecordingPath() {
        recordsPath = false;
    }

    /** Records the end of a tick. */
    void record(World world, ControllerState state) {
        Pose pose = world.pose();
        hash(pose.x());
        hash(pose.y());
        hash(pose.heading());
        WheelSpeeds speeds = world.wheelSpeeds();
        hash(speeds.left());
        hash(speeds.right());
        int sensors = world.robot().sensors().size();
        for (int i = 0; i < sensors; i++) {
            hash(world.reportedReading(i));
        }
        if (recordsPath) {
            path.record(pose.x(), pose.y(), PathTag.of(state, world));
        }
    }

    /** Hashes the raw bits of a number, so that a single different bit changes the hash. */
    private void hash(double value) {
        long mixed = (hash ^ Double.doubleToLongBits(value)) * MULTIPLIER;
        hash = mixed ^ (mixed >>> 29);
    }

    long hash() {
        return hash;
    }

    RobotPath path() {
        return path.view();
    }
}
