package faultline.paint.scene;

/** Lengths that people read easily: 1, 2 or 5 times a power of ten metres. */
final class NiceSteps {

    private static final double[] LEADING = {1, 2, 5, 10};

    private NiceSteps() {}

    /** The least round length not below a positive one, metres. */
    static double atLeast(double metres) {
        double power = Math.pow(10, Math.floor(Math.log10(metres)));
        for (double leading : LEADING) {
            if (leading * power >= metres) {
                return leading * power;
            }
        }
        return 10 * power;
    }

    /** Into how many parts a round length divides into round lengths: 1 and 5 into five, 2 into four. */
    static int subdivisions(double round) {
        double leading = round / Math.pow(10, Math.floor(Math.log10(round) + 1e-9));
        return Math.round(leading) == 2 ? 4 : 5;
    }

    /** The name of a round length of a millimetre or more, in the unit that makes it a whole number. */
    static String format(double round) {
        if (round >= 1000) {
            return formatWhole(round / 1000, "km");
        }
        if (round >= 1) {
            return formatWhole(round, "m");
        }
        return round >= 0.01 ? formatWhole(round * 100, "cm") : formatWhole(round * 1000, "mm");
    }

    private static String formatWhole(double value, String unit) {
        return Math.round(value) + " " + unit;
    }
}
