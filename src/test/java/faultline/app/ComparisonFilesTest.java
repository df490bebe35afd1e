package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ComparisonFilesTest {

    @ParameterizedTest
    @CsvSource({
        "page.html, page.csv, page-2.xml",
        "page.htm, page.csv, page-2.xml",
        "page, page.csv, page-2.xml",
        "a.html.b, a.html.b.csv, a.html.b-2.xml"
    })
    void theOtherFilesHaveTheNameOfThePage(String page, String table, String replay) throws UsageException {
        ComparisonFiles files = new ComparisonFiles(Path.of("folder", page), 2);
        assertEquals(Path.of("folder", page), files.page());
        assertEquals(Path.of("folder", table), files.table());
        assertEquals(Path.of("folder", replay), files.replay(1));
    }
}
