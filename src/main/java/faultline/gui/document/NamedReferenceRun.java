package faultline.gui.document;

import faultline.engine.session.ReferenceRun;

/**
 * An earlier run that is shown beside the one on the bench.
 *
 * @param name of its scenario
 * @param seed of its random numbers
 * @param dt the length of its ticks, seconds
 * @param run where the robot was
 */
public record NamedReferenceRun(String name, long seed, double dt, ReferenceRun run) {}
