package faultline.gui.window;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/**
 * The positions of the speed slider, ten to a decade from a tenth to a hundred times real time, and as fast as possible above. Real time
 * has three positions, so that a hand finds it.
 */
final class SpeedScale {

    private static final double[] DECADE = {1, 1.25, 1.6, 2, 2.5, 3, 4, 5, 6, 8};
    private static final int FIRST_REAL_TIME = 10;
    private static final int EXTRA = 2;
    private static final int FASTEST_PACED = 30 + EXTRA;

    /** As fast as possible. */
    static final int MOST = FASTEST_PACED + 1;

    /** Real time: the middle one of its positions. */
    static final int REAL_TIME = FIRST_REAL_TIME + 1;

    private SpeedScale() {
    }

    /** How many times real time a position stands for; positive infinity for as fast as possible. */
    static double speed(int position) {
        if (position >= MOST) {
            return Double.POSITIVE_INFINITY;
        }
        int place = position <= FIRST_REAL_TIME ? position : Math.max(FIRST_REAL_TIME, position - EXTRA);
        return DECADE[place % DECADE.length] * new double[] {0.1, 1, 10, 100}[place / DECADE.length];
    }

    /** The next position with a lower speed. */
    static int slower(int position) {
        int next = position;
        while (next > 0 && speed(next) >= speed(position)) {
            next--;
        }
        return middle(next);
    }

    /** The next position with a higher speed. */
    static int faster(int position) {
        int next = position;
        while (next < MOST && speed(next) <= speed(position)) {
            next++;
        }
        return middle(next);
    }

    private static int middle(int position) {
        return speed(position) == 1 ? REAL_TIME : position;
    }

    /** A speed for people. */
    static String text(double speed) {
        return new DecimalFormat("0.###", DecimalFormatSymbols.getInstance(Locale.ROOT)).format(speed) + "×";
    }
}
