package faultline.gui.document;

import faultline.engine.session.ReferenceRun;

/**
 * A reference run that is shown beside the run.
 *
 * @param name the name of its scenario
 * @param seed its seed
 * @param dt the length of its ticks, seconds
 * @param run the robot's poses
 */
public record NamedReferenceRun(String name, long seed, double dt, ReferenceRun run) {}
