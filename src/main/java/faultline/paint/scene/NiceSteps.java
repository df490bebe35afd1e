package faultline.paint.scene;

/** Chooses nice lengths: 1, 2 or 5 times a power of ten metres. */
final class NiceSteps {

    private static final double[] LEADING = {1, 2, 5, 10};

    private NiceSteps() {}

    /** Returns the least nice length not below a positive one, metres. */
    static double atLeast(double metres) {
        double power = Math.pow(10, Math.floor(Math.log10(metres)));
        for (double leading : LEADING) {
            if (leading * power >= metres) {
                return leading * power;
            }
        }
        return 10 * power;
    }

    /** Returns the number of nice steps that a nice length is divided into: five, or four if it begins with 2. */
    static int subdivisions(double round) {
        double leading = round / Math.pow(10, Math.floor(Math.log10(round) + 1e-9));
        return Math.round(leading) == 2 ? 4 : 5;
    }

    /** Returns the text of a nice length of at least a millimetre, in the unit that makes it an integer. */
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
