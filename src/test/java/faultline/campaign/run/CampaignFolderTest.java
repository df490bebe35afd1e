package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.plan.SamplePlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Folders that a campaign or a merge refuses, because it would write to a file of another kind or purpose. */
class CampaignFolderTest {

    private static final String PLAN = SamplePlan.text(
            "", "<worlds><scenario file=\"scenario-1.xml\"/></worlds><set attribute=\"@duration\" value=\"1\"/>");

    @TempDir
    Path folder;

    private Path plan;
    private Path part;
    private Path out;

    @BeforeEach
    void makeACampaign() throws Exception {
        plan = Files.writeString(folder.resolve("study.xml"), PLAN);
        Files.writeString(folder.resolve("scenario-1.xml"), SamplePlan.ROOM);
        part = folder.resolve("part");
        out = Files.createDirectory(folder.resolve("out"));
        make(part, false);
    }

    private void make(Path campaign, boolean resume) throws Exception {
        make(PlanFiles.read(plan), campaign, resume);
    }

    private static void make(CampaignPlan plan, Path campaign, boolean resume) throws Exception {
        CampaignRunner runner = new CampaignRunner(plan, new CampaignFolder(campaign), Shard.ALL, 1);
        assertTrue(runner.run(resume, (made, runs) -> {}, () -> false).isComplete());
    }

    private void merge() throws Exception {
        new CampaignMerge(List.of(new CampaignFolder(part))).writeTo(new CampaignFolder(out));
    }

    private void cannotMerge(String refusal) throws IOException {
        assertEquals(refusal, assertThrows(IOException.class, this::merge).getMessage());
        assertTrue(Files.notExists(out.resolve("replays")), "nothing was merged");
    }

    @ParameterizedTest
    @ValueSource(strings = {"runs.csv", "timing.csv", "campaign.json"})
    void aFolderInThePlaceOfATableIsRefused(String name) throws Exception {
        Path table = Files.createDirectory(out.resolve(name));
        cannotMerge(table + ": this is a folder; expected a file");
    }

    @Test
    void aDeviceInThePlaceOfATableIsRefused() throws Exception {
        Path device = Path.of("/dev/null");
        assumeTrue(Files.exists(device));
        Path table = Files.createSymbolicLink(out.resolve("timing.csv"), device);
        cannotMerge(table + ": this is not a regular file; expected a table");
        Files.delete(table);
    }

    @Test
    void aMergeDoesNotReplaceATableOfAPartThroughALink() throws Exception {
        Path table = Files.createLink(out.resolve("runs.csv"), part.resolve("runs.csv"));
        cannotMerge(table + ": this is also another file of the campaign; expected a different file");
    }

    /** A table without the expected header would be written from its start. */
    @ParameterizedTest
    @ValueSource(strings = {"study.xml", "scenario-1.xml"})
    void aResumedCampaignDoesNotReplaceAFileOfItsPlanThroughALink(String name) throws Exception {
        Path input = folder.resolve(name);
        String text = Files.readString(input);
        Path table = part.resolve("timing.csv");
        Files.delete(table);
        Files.createLink(table, input);
        IOException refusal = assertThrows(IOException.class, () -> make(part, true));
        assertEquals(
                table + ": this is also another file of the campaign; expected a different file", refusal.getMessage());
        assertEquals(text, Files.readString(input));
    }

    @Test
    void theCopyOfAPlanIsNotWrittenOverThePlan() throws Exception {
        Path inside = Files.createDirectory(out.resolve("plan"));
        plan = Files.move(plan, inside.resolve("plan.xml"));
        Files.move(folder.resolve("scenario-1.xml"), inside.resolve("scenario-1.xml"));
        IOException refusal = assertThrows(IOException.class, () -> make(out, false));
        assertEquals(plan + ": the plan is made of this file; expected another folder", refusal.getMessage());
        make(part, true);
    }

    @Test
    void aMergeIntoTheFolderOfACampaignIsRefused() throws Exception {
        make(out, false);
        IOException refusal = assertThrows(IOException.class, this::merge);
        assertEquals(out + ": there is a campaign already; expected another folder", refusal.getMessage());
    }

    @Test
    void aTableWithoutItsManifestIsNotContinued() throws Exception {
        Path table = Files.writeString(out.resolve("runs.csv"), "mine");
        IOException refusal = assertThrows(IOException.class, () -> make(out, true));
        assertEquals(out + ": there is a runs.csv without its campaign.json", refusal.getMessage());
        assertEquals("mine", Files.readString(table));
    }

    @Test
    void aMergeRemovesTheTemporaryFilesOfAKilledOne() throws Exception {
        Path temporary = Files.createFile(out.resolve(".faultline-1.tmp"));
        merge();
        assertTrue(Files.notExists(temporary));
    }
}
