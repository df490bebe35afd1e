package faultline.gui.panel;

import faultline.gui.text.Texts;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.ParseException;
import java.util.Locale;
import java.util.regex.Pattern;
import javax.swing.text.DefaultFormatter;

/** Numbers in fields: written with a point in every country, read with a point or a comma, and only within their limits. */
final class PlainNumber extends DefaultFormatter {

    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d{1,12}(\\.\\d{0,12})?|\\.\\d{1,12})");

    private final transient DecimalFormat format;
    private double least;
    private double most;

    /** Numbers from {@code least} to {@code most}, written by a pattern of {@link DecimalFormat}. */
    PlainNumber(String pattern, double least, double most) {
        this.format = new DecimalFormat(pattern, DecimalFormatSymbols.getInstance(Locale.ROOT));
        limit(least, most);
        setOverwriteMode(false);
    }

    void limit(double newLeast, double newMost) {
        least = newLeast;
        most = newMost;
    }

    @Override
    public Double stringToValue(String text) throws ParseException {
        String plain = text.strip().replace(',', '.');
        if (!NUMBER.matcher(plain).matches()) {
            throw new ParseException(Texts.text("number.none"), 0);
        }
        double value = Double.parseDouble(plain);
        if (value < least || value > most) {
            throw new ParseException(limits(), 0);
        }
        return value;
    }

    @Override
    public String valueToString(Object value) {
        return value instanceof Number number ? write(number.doubleValue()) : "";
    }

    String write(double value) {
        return format.format(value);
    }

    /** What is allowed, in words. */
    String limits() {
        return Texts.text("number.limits", write(least), write(most));
    }
}
