package faultline.control.diagnosis;

/**
 * How far around the robot evidence is collected and mapped. A robot that keeps far from its wall needs more of it. The
 * grid wraps at its borders, so the reach is limited by the distance at which two places would share a cell.
 *
 * @param distance what sensors measure farther than this from the robot's centre is not used, metres
 * @param gridSize the number of cells along each axis of the evidence grid, a power of two
 * @param windowSize the number of cells along each axis of the local map, an even number
 * @param holdsWanted whether the local map holds a wall at the wanted distance
 */
public record EvidenceReach(double distance, int gridSize, int windowSize, boolean holdsWanted) {

    /** The largest distance from the robot's centre to a wall that the local map holds, metres. */
    public static final double MAX_CENTRE_DISTANCE = 2;

    /** The distance from the robot's centre to a wall up to which the least reach is enough, metres. */
    private static final double NEAR = 0.9;

    /** The local map extends this far beyond the wall at the wanted distance, metres. */
    private static final double BEYOND_WALL = 0.35;

    private static final int LARGE_GRID = 256;

    /**
     * The reach for walls near the robot. The grid wraps after 3.2 m. The robot rolls up to 0.7 m while evidence counts
     * in an inspection, and up to 1 m while it counts in the local map, which extends by 0.9 m. So places within the
     * reach never share a cell.
     */
    static final EvidenceReach LEAST = new EvidenceReach(1.25, 128, 72, true);

    /** The reach if the wall at the wanted distance is too far away for the local map. */
    private static final EvidenceReach NOT_ENOUGH = new EvidenceReach(1.25, 128, 72, false);

    /** {@return whether the local map is larger than for walls near the robot} */
    public boolean isLarge() {
        return windowSize > LEAST.windowSize;
    }

    /**
     * Returns the reach that a wanted distance needs. It grows in proportion, because a sensor that looks diagonally
     * sees the wall farther away. A large grid wraps after 6.4 m, and at the largest distance the reach is 2.78 m and
     * the local map extends by 2.35 m.
     *
     * @param centreDistance the distance from the robot's centre to a wall that it wants to keep, metres
     */
    static EvidenceReach of(double centreDistance) {
        if (centreDistance <= NEAR) {
            return LEAST;
        }
        if (centreDistance > MAX_CENTRE_DISTANCE) {
            return NOT_ENOUGH;
        }
        double reach = centreDistance * (LEAST.distance / NEAR);
        int half = (int) Math.ceil((centreDistance + BEYOND_WALL) * EvidenceGrid.CELLS_PER_METRE);
        return new EvidenceReach(reach, LARGE_GRID, 2 * half, true);
    }
}
