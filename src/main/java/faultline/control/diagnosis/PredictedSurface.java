package faultline.control.diagnosis;

/**
 * A place on the robot's path where a surface was predicted that the front sensor did not see.
 *
 * @param x metres
 * @param y metres
 * @param cos the cosine of the direction of the path
 * @param sin the sine of it
 */
record PredictedSurface(double x, double y, double cos, double sin) {

    /** The surface may be nearer than predicted by this, metres. */
    private static final double NEARER = 0.05;

    /** It may be farther by this, metres. */
    static final double FARTHER = 0.15;

    private static final double STEP = EvidenceGrid.CELL;

    /** Returns the surface at a distance from a sensor that looks ahead. */
    static PredictedSurface ahead(DeadReckoning reckoning, MountedCone cone, double distance) {
        double cos = reckoning.headingCos();
        double sin = reckoning.headingSin();
        double forward = cone.x() + distance;
        return new PredictedSurface(
                reckoning.x() + cos * forward - sin * cone.y(),
                reckoning.y() + sin * forward + cos * cone.y(),
                cos,
                sin);
    }

    /** Returns whether the whole part of the path where the surface can be was seen free. */
    boolean isRefuted(EvidenceGrid grid, int oldest, int asked) {
        for (double along = -NEARER; along < FARTHER; along += STEP) {
            int column = EvidenceGrid.cellOf(x + along * cos);
            int row = EvidenceGrid.cellOf(y + along * sin);
            if (grid.freeBy(column, row, oldest, asked) == 0) {
                return false;
            }
        }
        return true;
    }
}
