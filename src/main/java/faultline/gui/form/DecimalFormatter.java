package faultline.gui.form;

import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.ParseException;
import java.util.Locale;
import java.util.OptionalDouble;
import javax.swing.JFormattedTextField;
import javax.swing.text.DefaultFormatter;

/**
 * Formats numbers in fields with a decimal point in every locale; parses numbers as in files, also with a comma, within
 * limits, and only whole ones if the pattern has no decimals. While the text of a field is that of its number, the
 * number stays as it is, with more decimals than are shown or outside of the limits.
 */
final class DecimalFormatter extends DefaultFormatter {

    private final transient DecimalFormat format;
    /** The same without zeros at the end. */
    private final transient DecimalFormat limitFormat;

    private double min;
    private double max;

    /** Creates a formatter for numbers from {@code min} to {@code max} with a pattern of {@link DecimalFormat}. */
    DecimalFormatter(String pattern, double min, double max) {
        this.format = new DecimalFormat(pattern, DecimalFormatSymbols.getInstance(Locale.ROOT));
        this.limitFormat = (DecimalFormat) format.clone();
        limitFormat.setMinimumFractionDigits(0);
        setLimits(min, max);
        setOverwriteMode(false);
    }

    void setLimits(double newMin, double newMax) {
        min = newMin;
        max = newMax;
    }

    void setMax(double newMax) {
        setLimits(min, newMax);
    }

    /**
     * Shows the value of a field. A text that is selected as a whole stays so: a field formats its value when it gets
     * the focus, and a digit that follows at once must replace it.
     */
    @Override
    public void install(JFormattedTextField field) {
        boolean selected = field != null
                && field.getSelectionStart() < field.getSelectionEnd()
                && field.getSelectionEnd() - field.getSelectionStart()
                        == field.getDocument().getLength();
        super.install(field);
        if (selected) {
            field.selectAll();
        }
    }

    @Override
    public Double stringToValue(String text) throws ParseException {
        OptionalDouble present = presentValue();
        if (present.isPresent() && text.equals(format(present.getAsDouble()))) {
            return present.getAsDouble();
        }
        String normalized = text.strip().replace(',', '.');
        BigDecimal exact =
                DecimalText.parse(normalized).orElseThrow(() -> new ParseException(Messages.get("number.none"), 0));
        double value = DecimalText.toDouble(exact, normalized);
        if (value < min
                || value > max
                || isWhole() && exact.stripTrailingZeros().scale() > 0) {
            throw new ParseException(limitsText(), 0);
        }
        return value;
    }

    /** Returns whether only whole numbers are allowed, because the pattern has no decimals. */
    private boolean isWhole() {
        return format.getMaximumFractionDigits() == 0;
    }

    /** Returns the number of the field; empty if it has none. */
    private OptionalDouble presentValue() {
        JFormattedTextField field = getFormattedTextField();
        return field != null && field.getValue() instanceof Number number && !Double.isNaN(number.doubleValue())
                ? OptionalDouble.of(number.doubleValue())
                : OptionalDouble.empty();
    }

    @Override
    public String valueToString(Object value) {
        return value instanceof Number number ? format(number.doubleValue()) : "";
    }

    /** Returns the text of a number; that of no number is empty. */
    String format(double value) {
        return Double.isNaN(value) ? "" : format.format(value);
    }

    /** Returns a text that states the limits. */
    String limitsText() {
        return Messages.get(
                isWhole() ? "number.limits.whole" : "number.limits", limitFormat.format(min), limitFormat.format(max));
    }
}
