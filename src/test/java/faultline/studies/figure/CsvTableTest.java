package faultline.studies.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.campaign.run.Csv;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CsvTableTest {

    @Test
    void aTextWithACommaIsOneCell() {
        CsvTable table = new CsvTable("what", "t_s");
        table.addRow("taken for its end, ROUND", -0.05);
        assertEquals("what,t_s\n\"taken for its end, ROUND\",-0.05\n", table.toCsv());
    }

    @ParameterizedTest
    @CsvSource({
        "0.12345678, 0.1234568",
        "-1234567.8, -1234568",
        "0.00012345678, 0.0001234568",
        "1.99999996, 2",
        "2.5, 2.5",
        "1e-10, 0",
        "NaN, ''",
        "Infinity, ''"
    })
    void numbersHaveSevenDigits(double number, String cell) {
        CsvTable table = new CsvTable("x_m");
        table.addRow(number);
        assertEquals("x_m\n" + cell + "\n", table.toCsv());
    }

    @Test
    void everyRowOfTheResultsHasACellForEachColumn() throws IOException {
        List<String> wrong = new ArrayList<>();
        try (Stream<Path> files = Files.walk(Path.of("docs/results"))) {
            for (Path file :
                    files.filter(path -> path.toString().endsWith(".csv")).toList()) {
                List<String> lines = Files.readAllLines(file);
                int columns = Csv.cells(lines.get(0)).size();
                lines.stream()
                        .filter(line -> Csv.cells(line).size() != columns)
                        .findFirst()
                        .ifPresent(line -> wrong.add(file + ": " + line));
            }
        }
        assertEquals(List.of(), wrong);
    }
}
