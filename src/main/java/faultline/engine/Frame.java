package faultline.engine;

import faultline.control.Telemetry;
import faultline.world.Snapshot;

/**
 * The state of a run at the end of a tick: the world, the controller's telemetry, and the path so far. Immutable.
 *
 * @param snapshot the world
 * @param telemetry the telemetry of the decision that took effect in this tick
 * @param leftVolts the voltage on the left motors in this tick
 * @param rightVolts the voltage on the right motors in this tick
 * @param path the robot's path so far
 * @param trajectoryHash the trajectory hash of all ticks so far
 */
public record Frame(
        Snapshot snapshot,
        Telemetry telemetry,
        double leftVolts,
        double rightVolts,
        RobotPath path,
        long trajectoryHash) {

    /**
     * {@return this frame with its path as part of a later path of the same run}
     *
     * @param later the later path
     */
    public Frame withPrefixOf(RobotPath later) {
        return new Frame(snapshot, telemetry, leftVolts, rightVolts, later.prefix(path), trajectoryHash);
    }
}
