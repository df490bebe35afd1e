package faultline.engine.metrics;

/** How often a robot has passed the places of a circuit. */
final class PlacePasses {

    /** The distance that the robot must drive before a pass of the same place counts again, metres. */
    private static final double MIN_LAP = 1.0;

    private final int[] passes;
    private final double[] lastPass;

    /** Creates the counts of a number of places that have not been passed. */
    PlacePasses(int places) {
        passes = new int[places];
        lastPass = new double[places];
    }

    /**
     * Records that the robot is at a place after it has driven a distance, metres; returns the number of this pass,
     * from 1, or 0 if it is still the pass before.
     */
    int record(int place, double travelled) {
        boolean counts = passes[place] == 0 || travelled - lastPass[place] > MIN_LAP;
        lastPass[place] = travelled;
        return counts ? ++passes[place] : 0;
    }
}
