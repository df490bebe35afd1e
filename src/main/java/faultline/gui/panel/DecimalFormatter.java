package faultline.gui.panel;

import faultline.gui.text.Messages;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.ParseException;
import java.util.Locale;
import java.util.regex.Pattern;
import javax.swing.text.DefaultFormatter;

/**
 * Numbers in fields: written with a point in every country, read with a point or a comma, and only within their limits.
 */
final class DecimalFormatter extends DefaultFormatter {

    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d{1,12}(\\.\\d{0,12})?|\\.\\d{1,12})");

    private final transient DecimalFormat format;
    private double min;
    private double max;

    /** Numbers from {@code least} to {@code most}, written by a pattern of {@link DecimalFormat}. */
    DecimalFormatter(String pattern, double least, double most) {
        this.format = new DecimalFormat(pattern, DecimalFormatSymbols.getInstance(Locale.ROOT));
        setLimits(least, most);
        setOverwriteMode(false);
    }

    void setLimits(double newLeast, double newMost) {
        min = newLeast;
        max = newMost;
    }

    @Override
    public Double stringToValue(String text) throws ParseException {
        String plain = text.strip().replace(',', '.');
        if (!NUMBER.matcher(plain).matches()) {
            throw new ParseException(Messages.get("number.none"), 0);
        }
        double value = Double.parseDouble(plain);
        if (value < min || value > max) {
            throw new ParseException(limitsText(), 0);
        }
        return value;
    }

    @Override
    public String valueToString(Object value) {
        return value instanceof Number number ? format(number.doubleValue()) : "";
    }

    String format(double value) {
        return format.format(value);
    }

    /** What is allowed, in words. */
    String limitsText() {
        return Messages.get("number.limits", format(min), format(max));
    }
}
