package faultline.engine.trace;

import java.math.BigDecimal;

/** The exact times of ticks, by one division of integers as far as that is exact. */
final class TickTimes {

    /** Integers up to this one are exact as doubles. */
    private static final long MAX_EXACT = 999_999_999_999_999L;

    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};

    private final BigDecimal dt;
    /** The length of a tick is this number of units; zero if integers are not exact. */
    private final long units;

    private final int scale;
    private final double unitsPerSecond;
    private final long maxExactTick;

    private TickTimes(BigDecimal dt) {
        this.dt = dt;
        boolean exact = dt.scale() > 0 && dt.scale() < POWERS.length;
        units = exact ? dt.unscaledValue().longValueExact() : 0;
        scale = exact ? dt.scale() : 1;
        unitsPerSecond = POWERS[scale];
        maxExactTick = exact ? MAX_EXACT / units : -1;
    }

    /** Returns the times of ticks of a length in seconds. The length is converted only once. */
    static TickTimes of(double dt) {
        return new TickTimes(BigDecimal.valueOf(dt));
    }

    /** Returns what {@link faultline.engine.SimulationSetup#timeOf} returns. */
    double timeOf(long tick) {
        return tick <= maxExactTick
                ? tick * units / unitsPerSecond
                : dt.multiply(BigDecimal.valueOf(tick)).doubleValue();
    }
}
