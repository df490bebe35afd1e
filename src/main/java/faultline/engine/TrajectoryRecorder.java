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

    /** Records the end of a tick, given the reported readings. */
    void record(World world, double[] readings, ControllerState state) {
        Pose pose = world.pose();
        WheelSpeeds speeds = world.wheelSpeeds();
        // A local variable is faster here, because each step depends on the one before.
        long next = mix(mix(mix(hash, pose.x()), pose.y()), pose.heading());
        next = mix(mix(next, speeds.left()), speeds.right());
        for (double reading : readings) {
            next = mix(next, reading);
        }
        hash = next;
        if (recordsPath) {
            path.record(pose.x(), pose.y(), PathTag.of(state, world));
        }
    }

    /**
     * Returns a hash with the bits of a number, so that a single different bit changes the hash; any NaN is the same.
     */
    private static long mix(long hash, double value) {
        long mixed = (hash ^ Double.doubleToLongBits(value)) * MULTIPLIER;
        return mixed ^ (mixed >>> 29);
    }

    long hash() {
        return hash;
    }

    RobotPath path() {
        return path.view();
    }
}
