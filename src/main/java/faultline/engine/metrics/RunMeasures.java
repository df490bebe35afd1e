package faultline.engine.metrics;

/**
 * The present measures of a run, from ground truth and the walls at the start. A measure that does not apply is not a
 * number.
 *
 * @param coverage the followed share of the wall that can be followed, in [0, 1]
 * @param isPathTooLong whether the coverage is not known, because the path along the wall has too many places
 * @param distanceRms the distance error on straight walls, metres, root mean square
 * @param followRms the distance error in all of FOLLOW, metres, root mean square
 * @param laps the number of times that the wall was passed, on average over its length
 */
public record RunMeasures(double coverage, boolean isPathTooLong, double distanceRms, double followRms, double laps) {

    /** The measures of a run that has followed no wall. */
    public static final RunMeasures NONE = new RunMeasures(Double.NaN, false, Double.NaN, Double.NaN, Double.NaN);
}
