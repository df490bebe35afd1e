package faultline.studies.figure;

import faultline.io.MessageText;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/** The table of the numbers in a figure. */
public final class CsvTable {

    private static final MathContext DIGITS = new MathContext(7);

    private final List<String> lines = new ArrayList<>();

    public CsvTable(String... columns) {
        lines.add(String.join(",", columns));
    }

    /** Adds a row of texts and numbers. Numbers have seven digits; those that are not finite give empty cells. */
    public void addRow(Object... cells) {
        List<String> texts = new ArrayList<>();
        for (Object cell : cells) {
            texts.add(cell instanceof Double number ? format(number) : MessageText.csvCell(cell.toString()));
        }
        lines.add(String.join(",", texts));
    }

    private static String format(double number) {
        if (!Double.isFinite(number)) {
            return "";
        }
        BigDecimal rounded = new BigDecimal(number).round(DIGITS);
        return rounded.abs().compareTo(new BigDecimal("1e-9")) < 0
                ? "0"
                : rounded.stripTrailingZeros().toPlainString();
    }

    public String toCsv() {
        return String.join("\n", lines) + "\n";
    }
}
