package faultline.floorplan;

import java.util.Locale;

/** The meaning of the values of a map image, as in the {@code mode} of ROS map_server files. */
public enum MapMode {
    /** Three values: free, occupied, unknown; cells between the thresholds are unknown. */
    TRINARY,
    /** As {@link #TRINARY}; the values between the thresholds, which would be graded, are unknown. */
    SCALE,
    /** The value of a pixel is its occupancy in per cent; values above 100 are unknown. */
    RAW;

    /** Returns the name in map files. */
    String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
