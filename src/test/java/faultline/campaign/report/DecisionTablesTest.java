package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class DecisionTablesTest {

    private static final Path DOCS = Path.of("docs");

    @Test
    void theDecisionsHoldTheTablesOfTheFiles() throws IOException {
        for (String page : DecisionTables.PAGES) {
            String text = Files.readString(DOCS.resolve("decisions").resolve(page));
            assertEquals(DecisionTables.markdown(DOCS, page), DecisionTables.block(text), page);
        }
    }
}
