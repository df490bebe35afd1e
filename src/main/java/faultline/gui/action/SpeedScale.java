package faultline.gui.action;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/**
 * The positions of the speed slider, ten to a decade from a tenth to a hundred times real time, and as fast as possible
 * above. Real time has three positions, so that a hand finds it.
 */
public final class SpeedScale {

    private static final double[] SPEEDS_PER_DECADE = {1, 1.25, 1.6, 2, 2.5, 3, 4, 5, 6, 8};
    private static final int FIRST_REAL_TIME_POSITION = 10;
    private static final int EXTRA_REAL_TIME_POSITIONS = 2;
    private static final int MAX_PACED_POSITION = 30 + EXTRA_REAL_TIME_POSITIONS;

    /** As fast as possible. */
    public static final int UNLIMITED = MAX_PACED_POSITION + 1;

    /** Real time: the middle one of its positions. */
    public static final int REAL_TIME_POSITION = FIRST_REAL_TIME_POSITION + 1;

    private SpeedScale() {}

    /** How many times real time a position stands for; positive infinity for as fast as possible. */
    public static double speedAt(int position) {
        if (position >= UNLIMITED) {
            return Double.POSITIVE_INFINITY;
        }
        int place = position <= FIRST_REAL_TIME_POSITION
                ? position
                : Math.max(FIRST_REAL_TIME_POSITION, position - EXTRA_REAL_TIME_POSITIONS);
        return SPEEDS_PER_DECADE[place % SPEEDS_PER_DECADE.length]
                * new double[] {0.1, 1, 10, 100}[place / SPEEDS_PER_DECADE.length];
    }

    /** The next position with a lower speed. */
    public static int nextSlower(int position) {
        int next = position;
        while (next > 0 && speedAt(next) >= speedAt(position)) {
            next--;
        }
        return normalizeRealTime(next);
    }

    /** The next position with a higher speed. */
    public static int nextFaster(int position) {
        int next = position;
        while (next < UNLIMITED && speedAt(next) <= speedAt(position)) {
            next++;
        }
        return normalizeRealTime(next);
    }

    private static int normalizeRealTime(int position) {
        return speedAt(position) == 1 ? REAL_TIME_POSITION : position;
    }

    /** A speed for people. */
    public static String format(double speed) {
        return new DecimalFormat("0.###", DecimalFormatSymbols.getInstance(Locale.ROOT)).format(speed) + "×";
    }
}
