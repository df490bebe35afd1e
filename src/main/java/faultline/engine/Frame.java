package faultline.engine;

import faultline.control.Telemetry;
import faultline.world.Snapshot;

/**
 * What is published for painting: the world at the end of a tick, what its controller showed, and the path so far. Immutable.
 *
 * @param world the world
 * @param control what the controller showed with the decision that acted in this tick
 * @param leftVolts on the left motors in this tick
 * @param rightVolts on the right motors in this tick
 * @param path the robot's path so far
 * @param trajectoryHash of all ticks so far
 */
public record Frame(Snapshot world, Telemetry control, double leftVolts, double rightVolts, Path path, long trajectoryHash) {
}
