package faultline.gui.document;

import java.util.OptionalLong;

/**
 * How the run on the bench compares with an earlier one.
 *
 * @param ghost the earlier run
 * @param divergence the first tick in which the two differ, empty while they do not
 * @param otherSeed whether the earlier run had other random numbers
 */
public record Haunting(Ghost ghost, OptionalLong divergence, boolean otherSeed) {
}
