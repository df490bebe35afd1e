package faultline.io;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Formats numbers of bytes for readers, in binary units, which have the same names in all languages. */
public final class ByteCount {

    private static final String[] UNITS = {"B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};

    /** The number of units of one size that the next one has. */
    private static final BigDecimal STEP = BigDecimal.valueOf(1024);

    private ByteCount() {}

    /**
     * {@return a number of bytes with its unit, at most one decimal and no unnecessary zero, such as 1.5 MiB} It is
     * rounded up, so that what exceeds a limit also looks larger.
     *
     * @param bytes the number of bytes, not negative
     */
    public static String format(long bytes) {
        int unit = 0;
        BigDecimal rounded = BigDecimal.valueOf(bytes);
        while (unit + 1 < UNITS.length && rounded.compareTo(STEP) >= 0) {
            unit++;
            rounded = BigDecimal.valueOf(bytes).divide(BigDecimal.valueOf(1L << 10 * unit), 1, RoundingMode.UP);
        }
        return rounded.stripTrailingZeros().toPlainString() + " " + UNITS[unit];
    }
}
