package faultline.engine;

import faultline.geometry.Pose;
import faultline.world.World;

/** What a run has left behind: the robot's path, and a hash of all that a tick comes to. */
final class TrajectoryRecorder {

    private final TrajectoryHash hash = new TrajectoryHash();
    private final PathRecorder path = new PathRecorder();

    /** Takes the end of a tick in. */
    void record(World world) {
        Pose pose = world.pose();
        hash.add(pose.x());
        hash.add(pose.y());
        hash.add(pose.heading());
        hash.add(world.wheelSpeeds().left());
        hash.add(world.wheelSpeeds().right());
        for (int i = 0; i < world.robot().sensors().size(); i++) {
            hash.add(world.reportedReading(i));
        }
        path.record(pose.x(), pose.y());
    }

    long hash() {
        return hash.value();
    }

    RobotPath path() {
        return path.view();
    }
}
