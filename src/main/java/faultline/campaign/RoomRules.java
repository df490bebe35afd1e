package faultline.campaign;

import faultline.world.WorldSpec;

/**
 * What a random room may hold.
 *
 * @param minCorner the sharpest inner corner, degrees, from {@link #MIN_CORNER} to {@link #MAX_CORNER}
 * @param visitors how many moving obstacles; a room without enough space has fewer
 */
public record RoomRules(int minCorner, int visitors) {

    /** The least that {@link #minCorner} may be, degrees. */
    public static final int MIN_CORNER = 45;

    /** The greatest that {@link #minCorner} may be, degrees. */
    public static final int MAX_CORNER = 90;

    /** The most visitors. */
    public static final int MAX_VISITORS = WorldSpec.DEFAULT_MAX_MOVING;

    /** Inner corners of 60 degrees and more, no visitors. */
    public static final RoomRules DEFAULT = new RoomRules(60, 0);

    /**
     * Creates the rules.
     *
     * @param minCorner the sharpest inner corner, degrees, from {@link #MIN_CORNER} to {@link #MAX_CORNER}
     * @param visitors how many moving obstacles; a room without enough space has fewer
     * @throws IllegalArgumentException if a value is outside its limits
     */
    public RoomRules {
        if (minCorner < MIN_CORNER || minCorner > MAX_CORNER || visitors < 0 || visitors > MAX_VISITORS) {
            throw new IllegalArgumentException("corners of " + minCorner + " degrees, " + visitors + " visitors");
        }
    }
}
