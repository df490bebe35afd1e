package faultline.gui.document;

import java.util.OptionalLong;

/**
 * A comparison of the run with a reference run.
 *
 * @param reference the reference run
 * @param divergence the first tick in which the runs differ, empty while they do not
 * @param seedDiffers whether the reference run has another seed
 */
public record RunComparison(NamedReferenceRun reference, OptionalLong divergence, boolean seedDiffers) {}
