package faultline.campaign.run;

import faultline.io.MessageText;
import java.util.ArrayList;
import java.util.List;

/**
 * Rows of comma-separated values as in RFC 4180, but with a single line feed as line end. Cells contain no line breaks.
 */
public final class Csv {

    private Csv() {}

    /**
     * {@return the row of some cells, with its line feed}
     *
     * @param cells the cells
     */
    public static String row(List<String> cells) {
        StringBuilder row = new StringBuilder();
        for (String cell : cells) {
            row.append(MessageText.csvCell(cell)).append(',');
        }
        row.setCharAt(row.length() - 1, '\n');
        return row.toString();
    }

    /**
     * {@return the cells of a row without its line feed}
     *
     * @param row the row
     */
    public static List<String> cells(String row) {
        List<String> cells = new ArrayList<>();
        StringBuilder cell = new StringBuilder();
        boolean inQuotes = false;
        for (int i = 0; i < row.length(); i++) {
            char c = row.charAt(i);
            if (c == '"' && inQuotes && i + 1 < row.length() && row.charAt(i + 1) == '"') {
                cell.append(row.charAt(++i));
            } else if (c == '"') {
                inQuotes = !inQuotes;
            } else if (c == ',' && !inQuotes) {
                cells.add(MessageText.textOfCell(cell.toString()));
                cell.setLength(0);
            } else {
                cell.append(c);
            }
        }
        cells.add(MessageText.textOfCell(cell.toString()));
        return cells;
    }
}
