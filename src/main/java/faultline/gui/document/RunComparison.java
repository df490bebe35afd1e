package faultline.gui.document;

import java.util.OptionalLong;

/**
 * How the run on the bench compares with an earlier one.
 *
 * @param reference the earlier run
 * @param divergence the first tick in which the two differ, empty while they do not
 * @param seedDiffers whether the earlier run had other random numbers
 */
public record RunComparison(NamedReferenceRun reference, OptionalLong divergence, boolean seedDiffers) {}
