package faultline.engine.metrics;

import faultline.io.ShortestDecimal;
import java.math.BigDecimal;

/** The exact times of ticks and their texts, by arithmetic with integers as far as that is exact. */
final class TickTimes {

    /** No two decimal fractions of this number of digits are the same double. */
    private static final int EXACT_DIGITS = 15;

    /** Below this, integers have no more digits than that. */
    private static final long MAX_EXACT = 1_000_000_000_000_000L;

    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};

    private final BigDecimal dt;
    /** The length of a tick is this number of units; zero if integers are not exact. */
    private final long units;

    private final int scale;
    private final double unitsPerSecond;
    private final long maxExactTick;

    private TickTimes(BigDecimal dt) {
        this.dt = dt;
        boolean exact = dt.scale() > 0 && dt.scale() < POWERS.length && dt.precision() <= EXACT_DIGITS;
        units = exact ? dt.unscaledValue().longValueExact() : 0;
        scale = exact ? dt.scale() : 1;
        unitsPerSecond = POWERS[scale];
        maxExactTick = exact ? (MAX_EXACT - 1) / units : -1;
    }

    /** Returns the times of ticks that last a number of seconds, which is converted once for many. */
    static TickTimes of(double dt) {
        return new TickTimes(BigDecimal.valueOf(dt));
    }

    /** Returns what {@link faultline.engine.SimulationSetup#timeOf} returns. */
    double timeOf(long tick) {
        return tick <= maxExactTick
                ? tick * units / unitsPerSecond
                : dt.multiply(BigDecimal.valueOf(tick)).doubleValue();
    }

    /**
     * Writes a time, in seconds, as {@link ShortestDecimal#write} does.
     *
     * @param time the exact time of the tick, or one near it
     * @param tick the tick
     * @param text receives the text
     * @param start the index at which the text begins
     * @return the end of the text
     */
    int write(double time, long tick, byte[] text, int start) {
        long exact = tick * units;
        return tick <= maxExactTick && exact / unitsPerSecond == time
                ? ShortestDecimal.writeDecimal(exact, scale, text, start)
                : ShortestDecimal.write(time, text, start);
    }
}
