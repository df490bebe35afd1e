package faultline.campaign;

import faultline.world.WorldSpec;

/**
 * The rules for a random room.
 *
 * @param minCorner the sharpest inner corner, degrees, from {@link #MIN_CORNER} to {@link #MAX_CORNER}
 * @param visitors the number of moving obstacles; a room without enough space has fewer
 */
public record RoomRules(int minCorner, int visitors) {

    /** The minimum of {@link #minCorner}, degrees. */
    public static final int MIN_CORNER = 45;

    /** The maximum of {@link #minCorner}, degrees. */
    public static final int MAX_CORNER = 90;

    /** The maximum number of visitors. */
    public static final int MAX_VISITORS = WorldSpec.DEFAULT_MAX_MOVING;

    /** Inner corners of 60 degrees and more, no visitors. */
    public static final RoomRules DEFAULT = new RoomRules(60, 0);

    /**
     * Creates the rules.
     *
     * @param minCorner the sharpest inner corner, degrees, from {@link #MIN_CORNER} to {@link #MAX_CORNER}
     * @param visitors the number of moving obstacles; a room without enough space has fewer
     * @throws IllegalArgumentException if a value is outside its limits
     */
    public RoomRules {
        if (minCorner < MIN_CORNER || minCorner > MAX_CORNER || visitors < 0 || visitors > MAX_VISITORS) {
            throw new IllegalArgumentException("corners of " + minCorner + " degrees, " + visitors + " visitors");
        }
    }
}
