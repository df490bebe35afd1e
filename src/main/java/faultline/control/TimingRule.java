package faultline.control;

import java.util.Locale;

/** The rule that determines the frames F3 and F4 of a spin past a wall, and the turn back. */
public enum TimingRule {

    /**
     * Two equal readings on either side of the nearest one, interpolated between samples; the turn back allows for the
     * motors' lag.
     */
    EQUAL_READINGS,

    /**
     * Our reading of eq. (4): the first sample at which the wall is seen and the first at which it is no longer seen,
     * and a turn back for exactly t_p = t_D / 2. The paper does not define at which readings F3 and F4 are taken. The
     * rule works only for a single wall.
     */
    RANGE;

    /** {@return the name in scenario files, in lower case with hyphens} */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
