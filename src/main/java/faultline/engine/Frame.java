package faultline.engine;

import faultline.control.Telemetry;
import faultline.world.Snapshot;

/**
 * What is published for painting: the world at the end of a tick, what its controller showed, the path so far, and what is remembered.
 * Immutable.
 *
 * @param world the world
 * @param control what the controller showed with the decision that acted in this tick
 * @param leftVolts on the left motors in this tick
 * @param rightVolts on the right motors in this tick
 * @param path the robot's path so far
 * @param trajectoryHash of all ticks so far
 * @param recording what is remembered of the run so far; empty where nothing was recorded
 */
public record Frame(Snapshot world, Telemetry control, double leftVolts, double rightVolts, Path path, long trajectoryHash,
        Recording recording) {

    Frame with(Recording newRecording) {
        return new Frame(world, control, leftVolts, rightVolts, path, trajectoryHash, newRecording);
    }
}
