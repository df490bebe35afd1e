package faultline.paint.surface;

/** Chooses nice numbers and lengths: 1, 2 or 5 times a power of ten. */
public final class NiceSteps {

    private static final double ROUNDING = 1e-12;

    private NiceSteps() {}

    /** Returns the least nice number not below a positive one, except for rounding errors. */
    public static double atLeast(double number) {
        double power = powerOfTen(number);
        // Divided by their powers of ten, some nice numbers such as 5e-6 are slightly more than 5.
        double leading = number / power * (1 - ROUNDING);
        return power * (leading <= 1 ? 1 : leading <= 2 ? 2 : leading <= 5 ? 5 : 10);
    }

    /** Returns the power of ten at or below a positive number. */
    public static double powerOfTen(double number) {
        return Double.parseDouble("1e" + (int) Math.floor(StrictMath.log10(number) + 1e-9));
    }

    /** Returns the number of nice steps that a nice length is divided into: five, or four if it begins with 2. */
    public static int subdivisions(double round) {
        double leading = round / powerOfTen(round);
        return Math.round(leading) == 2 ? 4 : 5;
    }

    /** Returns the text of a nice length of at least a millimetre, in the unit that makes it an integer. */
    public static String format(double round) {
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
