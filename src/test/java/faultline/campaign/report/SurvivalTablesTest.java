package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The survival tables of the results say what the csv files beside them say. */
class SurvivalTablesTest {

    @Test
    void theTextHoldsTheTablesOfTheFiles() throws IOException {
        assertEquals(
                SurvivalTables.markdown(Path.of("docs/results/survival")),
                SurvivalTables.block(Files.readString(Path.of("docs/results.md"))));
    }
}
