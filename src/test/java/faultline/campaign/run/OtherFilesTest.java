package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A campaign or a merge begins in a folder with files of the user. */
class OtherFilesTest {

    private static final String PLAN = text(2);

    private static final String REASON =
            "the campaign would replace or delete this file, and the folder has no campaign.json; use another folder";

    @TempDir
    Path folder;

    private static String text(int seeds) {
        return SamplePlan.text(
                "", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"%d\"/>".formatted(seeds));
    }

    private static CampaignPlan plan(int seeds) throws Exception {
        return SamplePlan.read(text(seeds));
    }

    private static void make(Path out, boolean resume) throws Exception {
        CampaignRunner runner = new CampaignRunner(plan(2), new CampaignFolder(out), Shard.ALL, 1);
        assertTrue(runner.run(resume, (made, runs) -> {}, () -> false).isComplete());
    }

    private static void merge(Path part, Path out) throws Exception {
        new CampaignMerge(List.of(new CampaignFolder(part))).writeTo(new CampaignFolder(out));
    }

    private Path write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "timing.csv",
                "plan/plan.xml",
                "plan/scenario-1.xml",
                "replays/run-0000123.xml",
                "replays/run-0000000.xml",
                "plan",
                "replays"
            })
    void aFileThatWouldBeReplacedOrDeletedRefusesTheFolder(String name) throws Exception {
        Path file = write("out/" + name, "mine");
        Path out = folder.resolve("out");
        for (boolean resume : new boolean[] {false, true}) {
            IOException refusal = assertThrows(IOException.class, () -> make(out, resume));
            assertEquals(file + ": " + REASON, refusal.getMessage());
        }
        Path part = folder.resolve("part");
        make(part, false);
        IOException refusal = assertThrows(IOException.class, () -> merge(part, out));
        assertEquals(file + ": " + REASON, refusal.getMessage());
        assertEquals("mine", Files.readString(file));
        assertTrue(Files.notExists(out.resolve("runs.csv")));
        assertTrue(Files.notExists(out.resolve("campaign.json")));
    }

    @Test
    void filesOfAStudyRemainBesideTheCampaign() throws Exception {
        List<String> names = List.of(
                "plan.xml",
                "room.xml",
                "plan/study.xml",
                "plan/scenario-2.xml",
                "replays/run-0000123-notes.xml",
                "replays/run-7.xml",
                "replays/best.xml");
        for (String name : names) {
            write(name, "mine");
        }
        make(folder, false);
        make(folder, true);
        for (String name : names) {
            assertEquals("mine", Files.readString(folder.resolve(name)), name);
        }
    }

    /** The files of the plan are copied before the manifest is written. */
    @Test
    void aCampaignThatWasKilledBeforeItsManifestWasWrittenIsMade() throws Exception {
        write("plan/plan.xml", PLAN);
        write("plan/scenario-1.xml", SamplePlan.ROOM);
        make(folder, true);
    }

    /** The manifest is written last. */
    @Test
    void aMergeThatWasKilledIsRepeated() throws Exception {
        Path part = folder.resolve("part");
        make(part, false);
        Path out = folder.resolve("out");
        merge(part, out);
        String runs = Files.readString(out.resolve("runs.csv"));
        Files.delete(out.resolve("campaign.json"));
        merge(part, out);
        assertEquals(runs, Files.readString(out.resolve("runs.csv")));
    }

    /** All campaigns with the same factors have the same columns. */
    @ParameterizedTest
    @ValueSource(strings = {"runs.csv", "timing.csv"})
    void theTablesOfAnotherCampaignWithTheSameColumnsRefuseTheFolder(String name) throws Exception {
        Path part = folder.resolve("part");
        make(part, false);
        Path other = folder.resolve("other");
        new CampaignRunner(plan(5), new CampaignFolder(other), Shard.ALL, 1)
                .run(false, (made, runs) -> {}, () -> false);
        String table = Files.readString(other.resolve(name));
        Path file = write("out/" + name, table);
        IOException refusal = assertThrows(IOException.class, () -> merge(part, folder.resolve("out")));
        assertEquals(file + ": " + REASON, refusal.getMessage());
        assertEquals(table, Files.readString(file));
    }

    /** A table that is only the beginning of the merged one is not that of a merge, which writes it at once. */
    @ParameterizedTest
    @ValueSource(strings = {"runs.csv", "timing.csv"})
    void aTableThatWouldBeContinuedOrCutRefusesTheFolder(String name) throws Exception {
        Path part = folder.resolve("part");
        make(part, false);
        Path out = folder.resolve("out");
        merge(part, out);
        Files.delete(out.resolve("campaign.json"));
        String merged = Files.readString(out.resolve(name));
        for (String table : List.of(merged.substring(0, merged.length() - 1), merged + "2\n")) {
            Path file = write("out/" + name, table);
            IOException refusal = assertThrows(IOException.class, () -> merge(part, out));
            assertEquals(file + ": " + REASON, refusal.getMessage());
            assertEquals(table, Files.readString(file));
        }
    }

    /** Each of these files is written after those before it. */
    @ParameterizedTest
    @ValueSource(strings = {"timing.csv", "replays/run-0000000.xml", "plan/plan.xml"})
    void aMergeOfPartsThatWasKilledBeforeItWroteAFileIsRepeated(String name) throws Exception {
        List<CampaignFolder> parts = new ArrayList<>();
        for (int part = 1; part <= 2; part++) {
            CampaignFolder in = new CampaignFolder(folder.resolve("part" + part));
            new CampaignRunner(plan(2), in, new Shard(part, 2), 1).run(false, (made, runs) -> {}, () -> false);
            parts.add(in);
        }
        Path out = folder.resolve("out");
        new CampaignMerge(parts).writeTo(new CampaignFolder(out));
        String content = Files.readString(out.resolve(name));
        Files.delete(out.resolve("campaign.json"));
        Files.delete(out.resolve(name));
        assertEquals(
                2, new CampaignMerge(parts).writeTo(new CampaignFolder(out)).made());
        assertEquals(content, Files.readString(out.resolve(name)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"runs.csv", "timing.csv", "plan/plan.xml"})
    void aMergeThatWasKilledIsNotRepeatedIfAFileIsNotItsOwn(String name) throws Exception {
        Path part = folder.resolve("part");
        make(part, false);
        Path out = folder.resolve("out");
        merge(part, out);
        Files.delete(out.resolve("campaign.json"));
        Path file = write("out/" + name, "mine");
        IOException refusal = assertThrows(IOException.class, () -> merge(part, out));
        assertEquals(file + ": " + REASON, refusal.getMessage());
        assertEquals("mine", Files.readString(file));
    }
}
