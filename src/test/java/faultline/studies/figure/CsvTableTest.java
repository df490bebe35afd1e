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

class CsvTableTest {

    @Test
    void aTextWithACommaIsOneCell() {
        CsvTable table = new CsvTable("what", "t_s");
        table.addRow("taken for its end, ROUND", -0.05);
        assertEquals("what,t_s\n\"taken for its end, ROUND\",-0.05\n", table.toCsv());
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
