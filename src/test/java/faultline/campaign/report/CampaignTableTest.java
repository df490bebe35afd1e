package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Csv;
import faultline.campaign.run.Shard;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CampaignTableTest {

    @TempDir
    private Path folder;

    private List<String> file;

    @BeforeEach
    void make() throws Exception {
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"3\"/>"));
        new CampaignRunner(plan, new CampaignFolder(folder), Shard.ALL, 1).run(false, (made, runs) -> {}, () -> false);
        file = Files.readAllLines(folder.resolve("runs.csv"));
    }

    private void write(List<String> lines) throws Exception {
        Files.writeString(folder.resolve("runs.csv"), String.join("\n", lines) + "\n");
    }

    @Test
    void linesAreThoseOfTheFile() throws Exception {
        CampaignTable table = CampaignTable.read(folder);
        assertEquals(file.stream().map(Csv::cells).toList(), table.lines());
        assertEquals(3, table.plan().runCount());
        assertTrue(table.ofThisProgram());
    }

    /** As another program may have written it. */
    @Test
    void linesAreInTheOrderOfThePlanWithAllColumns() throws Exception {
        List<String> rows = new ArrayList<>(file.subList(1, file.size()));
        Collections.reverse(rows);
        rows.add(0, file.get(0));
        int failure = Csv.cells(file.get(0)).indexOf("failure");
        write(rows.stream()
                .map(Csv::cells)
                .map(cells -> String.join(",", cells.subList(0, failure)))
                .toList());
        assertEquals(
                file.stream().map(Csv::cells).toList(),
                CampaignTable.read(folder).lines());
    }

    @Test
    void aPlanThatWasChangedIsNotThatOfTheRuns() throws Exception {
        Path plan = folder.resolve("plan/plan.xml");
        Files.writeString(plan, Files.readString(plan).replace("name=\"Test\"", "name=\"Other\""));
        assertFalse(CampaignTable.read(folder).ofThisProgram());
    }
}
