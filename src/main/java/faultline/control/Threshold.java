package faultline.control;

/**
 * A threshold of the wall follower's state diagram, which determines when a state is left. The map follower, which
 * drives when too few sensors are trusted, uses none of them.
 */
public enum Threshold {
    /** The margin beyond the wanted distance at which a wall ahead ends SEARCH, FOLLOW and ROUND. */
    AHEAD_MARGIN("aheadMargin", Quantity.SIGNED_MARGIN, 0),

    /**
     * The distance from the circle in which the platform turns at which an object ahead ends SEARCH, FOLLOW and ROUND.
     */
    TURN_CLEARANCE("turnClearance", Quantity.MARGIN, 0.06),

    /**
     * The difference between the equal readings of F3 and F4 and the nearest reading, as a share of that reading. At
     * this difference the nearest point has left the cone and readings rise fast.
     */
    TIMING_LEVEL("timingLevel", Quantity.SHARE, 0.08),

    /** The turn rate below which ALIGN ends. */
    SETTLED_RATE("settledRate", Quantity.TURN_RATE, 1),

    /** The amount by which a reading exceeds the wanted one if the followed wall has ended. */
    LOST_MARGIN("lostMargin", Quantity.MARGIN, 0.06),

    /** The innovation that counts as a corner, as a share of the final innovation at an outer corner. */
    BEND_SHARE("bendShare", Quantity.SHARE, 0.6),

    /** The turn after which a new search begins, because a wall that has not been seen by then does not exist. */
    GIVE_UP_ANGLE("giveUpAngle", Quantity.ANGLE, 400),

    /**
     * The angle between the headings at the start and the end of a spin up to which the spin has found the same wall
     * again: the slight corner ahead cannot be distinguished from that wall.
     */
    SAME_WALL_ANGLE("sameWallAngle", Quantity.ANGLE, 15),

    /**
     * After a spin that has found the same wall again, the robot steers through the slight corner by the left sensor
     * and checks for walls ahead only after this distance.
     */
    STEER_THROUGH("steerThrough", Quantity.MARGIN, 0.15);

    /** The quantity of a threshold, with the bounds of its values. */
    public enum Quantity {
        /** A length in metres. */
        MARGIN(0, 100, "m"),
        /** A length in metres, which may be negative. */
        SIGNED_MARGIN(-100, 100, "m"),
        /** A share. */
        SHARE(0.001, 1, ""),
        /** Degrees per second. */
        TURN_RATE(0.001, 3600, "deg/s"),
        /** Degrees. */
        ANGLE(0, 3600, "deg");

        private final double min;
        private final double max;
        private final String unit;

        Quantity(double min, double max, String unit) {
            this.min = min;
            this.max = max;
            this.unit = unit;
        }

        /** {@return the smallest value} */
        public double min() {
            return min;
        }

        /** {@return the greatest value} */
        public double max() {
            return max;
        }

        /** {@return the unit, empty for a share} */
        public String unit() {
            return unit;
        }
    }

    private final String fileName;
    private final Quantity quantity;
    private final double defaultValue;

    Threshold(String fileName, Quantity quantity, double defaultValue) {
        this.fileName = fileName;
        this.quantity = quantity;
        this.defaultValue = defaultValue;
    }

    /** {@return the name of the attribute in scenario files} */
    public String fileName() {
        return fileName;
    }

    /** {@return its quantity} */
    public Quantity quantity() {
        return quantity;
    }

    /** {@return the value that is used where a file gives none, in the unit of its quantity} */
    public double defaultValue() {
        return defaultValue;
    }
}
