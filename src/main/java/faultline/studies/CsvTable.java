package faultline.studies;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/** The table of the numbers in a figure. */
final class CsvTable {

    private static final MathContext DIGITS = new MathContext(7);

    private final List<String> lines = new ArrayList<>();

    CsvTable(String... columns) {
        lines.add(String.join(",", columns));
    }

    /** Adds a row of texts and numbers; numbers have seven digits, those that are not finite stay empty. */
    void addRow(Object... cells) {
        List<String> texts = new ArrayList<>();
        for (Object cell : cells) {
            texts.add(cell instanceof Double number ? format(number) : cell.toString());
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

    String toCsv() {
        return String.join("\n", lines) + "\n";
    }
}
