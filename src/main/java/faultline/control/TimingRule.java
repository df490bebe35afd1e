package faultline.control;

import java.util.Locale;

/** Which moments of a spin past a wall are F3 and F4, and what is made of them. */
public enum TimingRule {

    /**
     * Two equal readings on either side of the nearest one, interpolated between samples; the turn back allows for the
     * motors' lag.
     */
    EQUAL_READINGS,

    /**
     * The paper to the letter: the samples at which the wall was first seen and first no longer seen, and a turn back
     * for t_p = t_D / 2 and nothing more. Only a wall that stands alone can be timed so.
     */
    RANGE;

    /**
     * How far above the nearest reading equal readings are taken, as a share of that reading: by then the foot has left
     * the cone and readings rise fast.
     */
    public static final double MARGIN = 0.08;

    /**
     * The name in scenario files.
     *
     * @return lower case, with hyphens
     */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
