package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class CsvTest {

    @Test
    void cellsReadBackAsTheyWereWritten() {
        List<String> cells = List.of("", "plain", "a,b", "say \"no\"", "\"", "", "1.5", "");
        String row = Csv.row(cells);
        assertEquals(cells, Csv.cells(row.strip()));
        assertEquals(",plain,\"a,b\",\"say \"\"no\"\"\",\"\"\"\",,1.5,\n", row);
    }

    @Test
    void theLastCellMayBeInQuotes() {
        assertEquals(List.of("a", "b,c"), Csv.cells("a,\"b,c\""));
        assertEquals(List.of("a", "\""), Csv.cells("a,\"\"\"\""));
    }

    @Test
    void aLineBreakInACellBecomesABlank() {
        assertEquals("\"a b\",c\n", Csv.row(List.of("a\nb", "c")));
    }

    @Test
    void oneEmptyCellIsAnEmptyRow() {
        assertEquals("\n", Csv.row(List.of("")));
    }
}
