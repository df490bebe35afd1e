package faultline.gui;

import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * Measures again where a measurement is out of its bounds, because a machine that others use as well is slow now and then even by its own
 * processor time. What is slow each time is the program.
 */
public final class Attempts {

    private static final int MOST = 3;

    private Attempts() {
    }

    /** The first measurement within its bounds, or the last one. */
    public static <T> T firstWithin(Predicate<T> bounds, Supplier<T> measurement) {
        T measured = measurement.get();
        for (int attempt = 1; attempt < MOST && !bounds.test(measured); attempt++) {
            System.out.println("out of bounds, measured again: " + measured);
            measured = measurement.get();
        }
        return measured;
    }
}
