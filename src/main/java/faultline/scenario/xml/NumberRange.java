package faultline.scenario.xml;

import faultline.control.Threshold;
import faultline.io.DecimalText;
import faultline.io.Message;
import faultline.robot.DriveScale;
import faultline.sensor.SensorLimits;
import java.math.BigDecimal;

/**
 * The numbers that an attribute may have, with the same bounds as in the schema.
 *
 * @param min the lower bound
 * @param minInclusive whether the bound itself is allowed
 * @param max the upper bound
 * @param maxInclusive whether the bound itself is allowed
 * @param unit the rule that names the unit
 */
public record NumberRange(BigDecimal min, boolean minInclusive, BigDecimal max, boolean maxInclusive, Allowed unit) {

    /** The length of an edge, metres. */
    public static final NumberRange SIZE = closed(1e-6, ScenarioLimits.MAX_COORDINATE, Allowed.METRES);
    /** A coordinate, metres. */
    public static final NumberRange COORDINATE =
            closed(-ScenarioLimits.MAX_COORDINATE, ScenarioLimits.MAX_COORDINATE, Allowed.METRES);
    /** The range of a sensor, metres. */
    public static final NumberRange SENSOR_RANGE =
            closed(SensorLimits.MIN_RANGE, SensorLimits.MAX_RANGE, Allowed.METRES);
    /** The standard deviation of a sensor's noise, metres. */
    public static final NumberRange NOISE = closed(0, SensorLimits.MAX_NOISE, Allowed.METRES);
    /** An angle, degrees. */
    public static final NumberRange ANGLE = closed("-1000000", "1000000", Allowed.DEGREES);
    /** The full angle of a cone, degrees. */
    public static final NumberRange CONE = new NumberRange(
            BigDecimal.ZERO, false, decimal(StrictMath.toDegrees(SensorLimits.MAX_CONE)), false, Allowed.DEGREES);
    /** The greatest angle of incidence that a specular surface reflects back, degrees. */
    public static final NumberRange INCIDENCE_ANGLE =
            new NumberRange(BigDecimal.ZERO, false, new BigDecimal("90"), true, Allowed.DEGREES);
    /** A turn rate, degrees per second. */
    public static final NumberRange TURN_RATE = closed("0.001", "36000", Allowed.TURN_RATE);
    /** A speed, metres per second. */
    public static final NumberRange SPEED = closed("0", "1000", Allowed.SPEED);
    /** A speed other than 0, metres per second. */
    public static final NumberRange POSITIVE_SPEED = positive("1000", Allowed.SPEED);
    /** A time, seconds. */
    public static final NumberRange TIME = closed(0, ScenarioLimits.MAX_DURATION, Allowed.SECONDS);
    /** The length of a tick, seconds. */
    public static final NumberRange TICK = closed(ScenarioLimits.MIN_TICK, ScenarioLimits.MAX_TICK, Allowed.SECONDS);
    /** The time constant of a motor, seconds. */
    public static final NumberRange TIME_CONSTANT = closed("0", "1000", Allowed.SECONDS);
    /** A voltage, volts. */
    public static final NumberRange VOLTAGE = closed("-10000", "10000", Allowed.VOLTS);
    /** A voltage of a supply, volts. */
    public static final NumberRange POSITIVE_VOLTAGE = positive("10000", Allowed.VOLTS);
    /** A motor's speed for its voltage, metres per second and volt. */
    public static final NumberRange SPEED_CONSTANT = positive("1000", Allowed.SPEED_CONSTANT);
    /** The true share of a nominal value of the drive. */
    public static final NumberRange DRIVE_SCALE = closed(DriveScale.MIN, DriveScale.MAX, Allowed.UNITLESS);
    /** A gain of a controller. */
    public static final NumberRange GAIN = positive("1000000", Allowed.UNITLESS);
    /** A share. */
    public static final NumberRange FRACTION = closed("0", "1", Allowed.UNITLESS);

    /**
     * {@return the values of a threshold that measures a quantity}
     *
     * @param quantity the quantity
     */
    public static NumberRange of(Threshold.Quantity quantity) {
        Allowed unit =
                switch (quantity) {
                    case MARGIN, SIGNED_MARGIN -> Allowed.METRES;
                    case SHARE -> Allowed.UNITLESS;
                    case TURN_RATE -> Allowed.TURN_RATE;
                    case ANGLE -> Allowed.DEGREES;
                };
        return closed(quantity.min(), quantity.max(), unit);
    }

    private static NumberRange closed(String least, String most, Allowed unit) {
        return new NumberRange(new BigDecimal(least), true, new BigDecimal(most), true, unit);
    }

    /**
     * {@return a range that includes both bounds}
     *
     * @param least the lower bound
     * @param most the upper bound
     * @param unit the rule that names the unit
     */
    public static NumberRange closed(double least, double most, Allowed unit) {
        return new NumberRange(decimal(least), true, decimal(most), true, unit);
    }

    /** Returns a bound as it is written in a file. */
    private static BigDecimal decimal(double bound) {
        return new BigDecimal(DecimalText.format(bound));
    }

    private static NumberRange positive(String most, Allowed unit) {
        return new NumberRange(BigDecimal.ZERO, false, new BigDecimal(most), true, unit);
    }

    /**
     * {@return whether a number is inside}
     *
     * @param value the number
     */
    public boolean contains(BigDecimal value) {
        int below = value.compareTo(min);
        int above = value.compareTo(max);
        return (minInclusive ? below >= 0 : below > 0) && (maxInclusive ? above <= 0 : above < 0);
    }

    /**
     * Returns whether a value that was rounded to a double is within the bounds and not one of them; then the exact
     * value is, too. False for NaN.
     */
    boolean isInside(double rounded) {
        return rounded > min.doubleValue() && rounded < max.doubleValue();
    }

    /** {@return this range as a rule, such as "from 0 to 100 metres"} */
    public Message rule() {
        Allowed kind = minInclusive ? Allowed.CLOSED : maxInclusive ? Allowed.HALF_OPEN : Allowed.OPEN;
        return unit.with(kind.with(min.toPlainString(), max.toPlainString()));
    }
}
