package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class CsvTest {

    @Test
    void cellsReadBackAsTheyWereWritten() {
        List<String> cells = List.of("", "plain", "a,b", "say \"no\"", "\"", "", "1.5", "");
        String row = Csv.row(cells);
        assertEquals(cells, Csv.cells(row.strip()));
        assertEquals(",plain,\"a,b\",\"say \"\"no\"\"\",\"\"\"\",,1.5,\n", row);
    }

    /** A spreadsheet would take some of them for formulas. */
    @Test
    void cellsOfSignsReadBackAsTheyWereWritten() {
        assertEquals("'=a,''=a,-5,''-5,'-tail\n", Csv.row(List.of("=a", "'=a", "-5", "'-5", "-tail")));
        SplittableRandom random = new SplittableRandom(7);
        String signs = "'=+-@5a,\"";
        for (int i = 0; i < 100_000; i++) {
            List<String> cells = Stream.generate(() -> random.ints(random.nextInt(5), 0, signs.length())
                            .mapToObj(c -> signs.substring(c, c + 1))
                            .collect(Collectors.joining()))
                    .limit(3)
                    .toList();
            assertEquals(cells, Csv.cells(Csv.row(cells).stripTrailing()));
        }
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
