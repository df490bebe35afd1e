package faultline.gui.action;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/**
 * The positions of the speed slider: ten per decade from 0.1 to 100 times real time, and unlimited speed above. Real
 * time has three positions, so that it is easy to hit.
 */
public final class SpeedScale {

    private static final double[] SPEEDS_PER_DECADE = {1, 1.25, 1.6, 2, 2.5, 3, 4, 5, 6, 8};
    private static final int FIRST_REAL_TIME_POSITION = 10;
    private static final int EXTRA_REAL_TIME_POSITIONS = 2;
    private static final int MAX_PACED_POSITION = 30 + EXTRA_REAL_TIME_POSITIONS;

    /** The position of unlimited speed. */
    public static final int UNLIMITED = MAX_PACED_POSITION + 1;

    /** The middle one of the positions of real time. */
    public static final int REAL_TIME_POSITION = FIRST_REAL_TIME_POSITION + 1;

    private SpeedScale() {}

    /** Returns the speed of a position, times real time; positive infinity for unlimited speed. */
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

    /** Returns the next position with a lower speed. */
    public static int nextSlower(int position) {
        int next = position;
        while (next > 0 && speedAt(next) >= speedAt(position)) {
            next--;
        }
        return normalizeRealTime(next);
    }

    /** Returns the next position with a higher speed. */
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

    /** Returns a speed as text. */
    public static String format(double speed) {
        return new DecimalFormat("0.###", DecimalFormatSymbols.getInstance(Locale.ROOT)).format(speed) + "×";
    }
}
