package faultline.engine;

import faultline.control.Telemetry;
import faultline.world.Snapshot;

/**
 * What is published for painting: the world at the end of a tick, what its controller showed, the path so far, and what
 * is remembered. Immutable.
 *
 * @param snapshot the world
 * @param telemetry what the controller showed with the decision that acted in this tick
 * @param leftVolts on the left motors in this tick
 * @param rightVolts on the right motors in this tick
 * @param path the robot's path so far
 * @param trajectoryHash of all ticks so far
 * @param recording what is remembered of the run so far; empty where nothing was recorded
 */
public record Frame(
        Snapshot snapshot,
        Telemetry telemetry,
        double leftVolts,
        double rightVolts,
        RobotPath path,
        long trajectoryHash,
        Recording recording) {

    public Frame withRecording(Recording newRecording) {
        return new Frame(snapshot, telemetry, leftVolts, rightVolts, path, trajectoryHash, newRecording);
    }
}
