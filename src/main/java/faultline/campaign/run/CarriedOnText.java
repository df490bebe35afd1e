package faultline.campaign.run;

import faultline.engine.metrics.CarryOnMetrics;
import faultline.io.DecimalText;

/** The limits of {@link CarryOnMetrics} as tables and pages write them. */
public final class CarriedOnText {

    /** The share of the wall that must be passed. */
    public static final String SHARE = DecimalText.formatFixed(CarryOnMetrics.REQUIRED_SHARE, 2);

    /** The distance within which a place is passed. */
    public static final String DISTANCE = DecimalText.format(CarryOnMetrics.PASSING_DISTANCE) + " m";

    /** The time that the robot has. */
    public static final String LAPS = DecimalText.format(CarryOnMetrics.ALLOWED_LAPS) + " laps";

    /** The time that a lap takes for its corners. */
    public static final String CORNERS = DecimalText.format(CarryOnMetrics.CORNER_TIME) + " s";

    private CarriedOnText() {}
}
