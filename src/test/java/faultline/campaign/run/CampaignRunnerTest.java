package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.plan.SamplePlan;
import faultline.io.AtomicFile;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CampaignRunnerTest {

    private static final String PLAN = SamplePlan.text(
            "sampling=\"latin\"",
            """
            <worlds><scenario file="room.xml"/></worlds>
            <seeds count="4"/>
            <set attribute="robot/@speed" value="0.2..0.3"/>
            <set attribute="robot/sensor[front]/@cone" value="10 20 30"/>
            <faults><healthy/><fault sensor="front left" kind="off" at="1..4"/></faults>
            """);

    @TempDir
    Path folder;

    @TempDir
    static Path reference;

    private static byte[] expected;

    @BeforeAll
    static void makeTheWholeCampaignAtOnce() throws Exception {
        expected = runs(reference, Shard.ALL, 1, false);
        assertEquals(37, new String(expected).lines().count());
    }

    private static CampaignRunner runner(Path out, Shard shard, int jobs) throws Exception {
        return new CampaignRunner(SamplePlan.read(PLAN), new CampaignFolder(out), shard, jobs);
    }

    private static byte[] runs(Path out, Shard shard, int jobs, boolean resume) throws Exception {
        CampaignRunner.RunCounts result = runner(out, shard, jobs).run(resume, (made, runs) -> {}, () -> false);
        assertTrue(result.isComplete());
        assertEquals(0, result.broken());
        return Files.readAllBytes(out.resolve("runs.csv"));
    }

    @Test
    void theTableIsTheSameForAnyNumberOfJobs() throws Exception {
        assertArrayEquals(expected, runs(folder, Shard.ALL, 3, false));
    }

    /** The robot drives into the wall, and would stand there for the rest of the run. */
    @Test
    void aRunEndsWithItsVerdictOnRequest() throws Exception {
        assertEquals("6", simulatedSeconds("end=\"duration\""));
        assertTrue(Double.parseDouble(simulatedSeconds("end=\"verdict\"")) < 5);
    }

    private String simulatedSeconds(String attributes) throws Exception {
        String plan = SamplePlan.text(
                attributes,
                """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="controller/@type" value="drive"/>
                <set attribute="controller/@left" value="6"/>
                <set attribute="controller/@right" value="6"/>
                """);
        CampaignFolder out = new CampaignFolder(folder.resolve(attributes.replaceAll("\\W", "")));
        new CampaignRunner(SamplePlan.read(plan), out, Shard.ALL, 1).run(false, (made, runs) -> {}, () -> false);
        List<String> lines = Files.readAllLines(out.runs());
        int column = List.of(lines.get(0).split(",")).indexOf("simulated_s");
        return lines.get(1).split(",", -1)[column];
    }

    @Test
    void mergedPartsAreTheWholeCampaign() throws Exception {
        List<CampaignFolder> parts = new ArrayList<>();
        for (int part = 5; part >= 1; part--) {
            Path out = folder.resolve("part-" + part);
            runs(out, new Shard(part, 5), 2, true);
            parts.add(new CampaignFolder(out));
        }
        CampaignFolder merged = new CampaignFolder(folder.resolve("merged"));
        new CampaignMerge(parts).writeTo(merged);
        assertArrayEquals(expected, Files.readAllBytes(merged.runs()));
        assertEquals(replays(reference), replays(folder.resolve("merged")));
        assertEquals(
                Files.readAllLines(reference.resolve("timing.csv")).stream()
                        .map(CampaignRunnerTest::firstCell)
                        .toList(),
                Files.readAllLines(merged.timing()).stream()
                        .map(CampaignRunnerTest::firstCell)
                        .toList());
        assertEquals(
                Files.readString(reference.resolve("campaign.json")),
                Files.readString(folder.resolve("merged").resolve("campaign.json")));
    }

    private static String firstCell(String row) {
        return Csv.cells(row).get(0);
    }

    @Test
    void morePartsThanRunsAreMergedInAnyOrder() throws Exception {
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"2\"/>"));
        List<CampaignFolder> parts = new ArrayList<>();
        for (int part = 5; part >= 1; part--) {
            CampaignFolder out = new CampaignFolder(folder.resolve("part-" + part));
            new CampaignRunner(plan, out, new Shard(part, 5), 1).run(false, (made, runs) -> {}, () -> false);
            parts.add(out);
        }
        CampaignRunner.RunCounts merged = new CampaignMerge(parts).writeTo(new CampaignFolder(folder.resolve("all")));
        assertEquals(new CampaignRunner.RunCounts(2, 2, 0), merged);
    }

    private static List<String> replays(Path campaign) throws IOException {
        List<String> texts = new ArrayList<>();
        try (var files = Files.list(campaign.resolve("replays"))) {
            for (Path file : files.sorted().toList()) {
                texts.add(file.getFileName() + Files.readString(file));
            }
        }
        return texts;
    }

    @Test
    void aTableThatWasCutAnywhereIsEndedWithTheSameBytes() throws Exception {
        runs(folder, Shard.ALL, 1, false);
        for (int length : new int[] {0, 1, 50, 300, expected.length / 2, expected.length - 1, expected.length}) {
            Files.write(folder.resolve("runs.csv"), Arrays.copyOf(expected, length));
            assertArrayEquals(expected, runs(folder, Shard.ALL, 2, true), length + " bytes");
            assertEquals(
                    37, Files.readString(folder.resolve("timing.csv")).lines().count(), length + " bytes");
        }
    }

    /** Such as the zeros that a file system may leave in a file after the machine has failed. */
    @Test
    void aTableWhoseRestIsOneLongLineIsEndedWithTheSameBytes() throws Exception {
        runs(folder, Shard.ALL, 1, false);
        for (String table : List.of("runs.csv", "timing.csv")) {
            Path file = folder.resolve(table);
            Files.write(file, Arrays.copyOf(Files.readAllBytes(file), 3 * LineReader.MAX_LENGTH));
            assertArrayEquals(expected, runs(folder, Shard.ALL, 2, true), table);
            assertEquals(
                    37, Files.readString(folder.resolve("timing.csv")).lines().count(), table);
        }
    }

    @Test
    void aCancelledCampaignLeavesWholeRowsAndGoesOn() throws Exception {
        AtomicLong seen = new AtomicLong();
        CampaignRunner.RunCounts result =
                runner(folder, Shard.ALL, 2).run(false, (made, runs) -> seen.set(made), () -> seen.get() == 7);
        assertEquals(new CampaignRunner.RunCounts(7, 36, 0), result);
        assertEquals(8, Files.readString(folder.resolve("runs.csv")).lines().count());
        assertArrayEquals(expected, runs(folder, Shard.ALL, 2, true));
    }

    /**
     * A killed process may have left them just before, so they are as young as those of a process that still writes.
     */
    @Test
    void resumingRemovesTheTemporaryFilesOfAKilledProcessAndNoOthers() throws Exception {
        runs(folder, Shard.ALL, 1, false);
        List<String> names = List.of("", "plan", "replays");
        for (String name : names) {
            Files.createFile(folder.resolve(name).resolve(".faultline-1.tmp"));
            Files.createFile(folder.resolve(name).resolve(".faultline-notes"));
            Files.createFile(folder.resolve(name).resolve(".other.tmp"));
        }
        runs(folder, Shard.ALL, 1, true);
        for (String name : names) {
            assertTrue(Files.notExists(folder.resolve(name).resolve(".faultline-1.tmp")), name);
            assertTrue(Files.exists(folder.resolve(name).resolve(".faultline-notes")), name);
            assertTrue(Files.exists(folder.resolve(name).resolve(".other.tmp")), name);
        }
    }

    /** A report may be written to the folder of its campaign, also one that is reached by another path. */
    @Test
    void resumingKeepsTheTemporaryFilesThatAreBeingWritten() throws Exception {
        runs(folder, Shard.ALL, 1, false);
        Path report = folder.resolve("report.html");
        Path locked = Files.createFile(folder.resolve("replays/.faultline-1.tmp"));
        try (FileChannel channel = FileChannel.open(locked, StandardOpenOption.WRITE);
                AtomicFile out = AtomicFile.create(report)) {
            channel.lock();
            out.stream().write("<p>".getBytes(StandardCharsets.UTF_8));
            runs(folder.resolve("plan/.."), Shard.ALL, 1, true);
            out.commit();
        }
        assertEquals("<p>", Files.readString(report));
        assertTrue(Files.exists(locked));
    }

    @Test
    void aReplayHasTheTrajectoryOfItsRun() throws Exception {
        List<String> rows = new String(expected).lines().toList();
        int hash = Csv.cells(rows.get(0)).indexOf("trajectory_hash");
        try (var files = Files.list(reference.resolve("replays"))) {
            List<Path> replays = files.toList();
            assertEquals(20, replays.size());
            for (Path replay : replays) {
                int run = Integer.parseInt(replay.getFileName().toString().replaceAll("\\D", ""));
                assertEquals(
                        Csv.cells(rows.get(run + 1)).get(hash),
                        Scenario.load(replay).run().trajectoryHash());
            }
        }
    }

    @Test
    void aRunThatCannotBeMadeIsOneRowAndTheOthersAreMade() throws Exception {
        // Each is possible alone, but both poles together leave no room for the robot.
        String plan = SamplePlan.text(
                "",
                """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="world/circle[pole]/@x" value="0.6 2"/>
                <set attribute="world/circle[pole]/@y" value="0.5 1.2"/>
                """);
        CampaignPlan read = SamplePlan.read(plan);
        CampaignRunner.RunCounts result = new CampaignRunner(read, new CampaignFolder(folder), Shard.ALL, 2)
                .run(false, (made, runs) -> {}, () -> false);
        assertEquals(new CampaignRunner.RunCounts(4, 4, 1), result);
        List<String> rows = Files.readAllLines(folder.resolve("runs.csv"));
        assertTrue(rows.get(2).contains(",broken,"), rows.get(2));
        assertTrue(rows.get(2).contains("where it touches or overlaps"), rows.get(2));
        assertEquals(result, merged(folder));
    }

    /**
     * Parts of a campaign may be made in several folders, whose names may be as long as a cell. The line is that of the
     * plan if the plan sets the value.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            <set attribute="world/circle[pole]/@x" value="0.6 2"/><set attribute="world/circle[pole]/@y" value="0.5 1.2"/> | ,"<robot> starts at 0.6,1.2 where it touches or overlaps
            <seeds count="20"/><faults><fault kind="off" sensor="front" at="1..2" until="1.01..2.01"/></faults> | ,"plan.xml:2:135: until of <fault> is
            """)
    void theReasonOfABrokenRunDoesNotDependOnThePathOfThePlan(String elements, String reason) throws Exception {
        String plan = SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds>" + elements);
        List<String> tables = new ArrayList<>();
        for (String name : List.of("study.xml", "folder/".repeat(30) + "study.xml")) {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            Files.writeString(file, plan);
            Files.writeString(file.resolveSibling("room.xml"), SamplePlan.ROOM);
            Path out = folder.resolve("out-" + tables.size());
            new CampaignRunner(PlanFiles.read(file), new CampaignFolder(out), Shard.ALL, 2)
                    .run(false, (made, runs) -> {}, () -> false);
            tables.add(Files.readString(out.resolve("runs.csv")));
        }
        assertEquals(tables.get(0), tables.get(1));
        assertTrue(tables.get(0).contains(reason), tables.get(0));
    }

    /** The verdict of the second run would need the places of a circle of 100 km. */
    @Test
    void aRunWithoutAPossibleVerdictIsOneRowAndTheOthersAreMade() throws Exception {
        String plan = SamplePlan.text(
                "",
                """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="controller/@distance" value="0.3 100000 0.4"/>
                """);
        CampaignRunner.RunCounts result = new CampaignRunner(
                        SamplePlan.read(plan), new CampaignFolder(folder), Shard.ALL, 2)
                .run(false, (made, runs) -> {}, () -> false);
        assertEquals(new CampaignRunner.RunCounts(3, 3, 1), result);
        String broken = Files.readAllLines(folder.resolve("runs.csv")).get(2);
        assertTrue(broken.endsWith("m from the walls has too many places; expected at most 2000000"), broken);
        assertEquals(result, merged(folder));
    }

    @Test
    void aFaultThatAPlanCallsBrokenBreaksNoRun() throws Exception {
        String plan = SamplePlan.text(
                "",
                """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="@duration" value="1"/>
                <faults><healthy/><fault sensor="front left" kind="off" at="0.5" label="broken"/></faults>
                """);
        CampaignRunner.RunCounts result = new CampaignRunner(
                        SamplePlan.read(plan), new CampaignFolder(folder), Shard.ALL, 1)
                .run(false, (made, runs) -> {}, () -> false);
        assertEquals(new CampaignRunner.RunCounts(3, 3, 0), result);
        assertEquals(result, merged(folder));
    }

    private CampaignRunner.RunCounts merged(Path campaign) throws Exception {
        return new CampaignMerge(List.of(new CampaignFolder(campaign)))
                .writeTo(new CampaignFolder(folder.resolve("merged")));
    }

    /** Without the copy, the campaign can neither be reported nor opened in the window. */
    @ParameterizedTest
    @ValueSource(strings = {"plan.xml", "scenario-1.xml", "plan.xml scenario-1.xml"})
    void aResumedCampaignWritesWhatIsMissingOfTheCopyOfThePlan(String names) throws Exception {
        runs(folder, Shard.ALL, 2, false);
        Path copy = folder.resolve("plan");
        for (String name : names.split(" ")) {
            Files.delete(copy.resolve(name));
        }
        if (names.contains(" ")) {
            Files.delete(copy);
        }
        assertArrayEquals(expected, runs(folder, Shard.ALL, 2, true));
        assertEquals(PLAN, Files.readString(copy.resolve("plan.xml")));
        assertEquals(SamplePlan.ROOM, Files.readString(copy.resolve("scenario-1.xml")));
        assertEquals(36, new CampaignFolder(folder).readPlan().runCount());
    }

    @Test
    void aResumedCampaignLeavesACopyOfThePlanThatTheUserHasChanged() throws Exception {
        runs(folder, Shard.ALL, 2, false);
        Path copy = folder.resolve("plan");
        Files.writeString(copy.resolve("plan.xml"), "mine");
        Files.delete(copy.resolve("scenario-1.xml"));
        assertArrayEquals(expected, runs(folder, Shard.ALL, 2, true));
        assertEquals("mine", Files.readString(copy.resolve("plan.xml")));
        assertEquals(SamplePlan.ROOM, Files.readString(copy.resolve("scenario-1.xml")));
    }

    @Test
    void aFolderIsUsedForOneCampaignOnly() throws Exception {
        runs(folder, Shard.ALL, 2, false);
        refused("there is a campaign already", SamplePlan.read(PLAN), Shard.ALL, false);
        refused("is another part, 1/1; expected 1/2", SamplePlan.read(PLAN), new Shard(1, 2), true);
        refused("has another plan", SamplePlan.read(PLAN.replace("30", "31")), Shard.ALL, true);
    }

    private void refused(String why, CampaignPlan plan, Shard shard, boolean resume) {
        CampaignRunner runner = new CampaignRunner(plan, new CampaignFolder(folder), shard, 1);
        IOException refusal =
                assertThrows(IOException.class, () -> runner.run(resume, (made, runs) -> {}, () -> false));
        assertTrue(refusal.getMessage().contains(why), refusal.getMessage());
    }

    @Test
    void missingRepeatedAndUnfinishedPartsAreRefused() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = part(2);
        CampaignFolder three = part(3);
        cannotMerge("the runs from 24 to 35 are in no part", one, two);
        cannotMerge("run 0 is in no part", two, three);
        cannotMerge("run 12 is in no part", one, three);
        cannotMerge("2: this folder is given twice", one, two, two, three);
        Files.write(two.runs(), Arrays.copyOf(Files.readAllBytes(two.runs()), 900));
        cannotMerge("--shard 2/3 --resume makes the rest", one, two, three);
    }

    /** The first of five parts of two runs has none. */
    @Test
    void aPartWithoutRunsNeedsItsHeader() throws Exception {
        String plan = SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"2\"/>");
        CampaignFolder[] parts = new CampaignFolder[5];
        for (int number = 1; number <= 5; number++) {
            parts[number - 1] = new CampaignFolder(folder.resolve("part-" + number));
            new CampaignRunner(SamplePlan.read(plan), parts[number - 1], new Shard(number, 5), 1)
                    .run(false, (made, runs) -> {}, () -> false);
        }
        String header = Files.readString(parts[0].runs());
        assertEquals(1, header.lines().count(), header);
        for (String beginning : List.of("", header.substring(0, 9))) {
            Files.writeString(parts[0].runs(), beginning);
            cannotMerge(parts[0] + ": part 1/5 has no table; campaign with --shard 1/5 --resume makes it", parts);
        }
        Files.delete(parts[0].runs());
        cannotMerge(parts[0] + ": part 1/5 has no table; campaign with --shard 1/5 --resume makes it", parts);
        new CampaignRunner(SamplePlan.read(plan), parts[0], new Shard(1, 5), 1)
                .run(true, (made, runs) -> {}, () -> false);
        new CampaignMerge(List.of(parts)).writeTo(new CampaignFolder(folder.resolve("merged")));
        assertEquals(3, Files.readAllLines(folder.resolve("merged/runs.csv")).size());
    }

    @Test
    void partsOfDifferentPlansAreRefused() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = new CampaignFolder(folder.resolve("part-2"));
        new CampaignRunner(SamplePlan.read(PLAN.replace("30", "31")), two, new Shard(2, 3), 2)
                .run(false, (made, runs) -> {}, () -> false);
        cannotMerge(two + ": this is of another campaign than " + one, one, two, part(3));
    }

    @Test
    void aMergeReplacesOnlyATableThatAnInterruptedMergeHasLeft() throws Exception {
        CampaignFolder whole = new CampaignFolder(reference);
        CampaignFolder merged = new CampaignFolder(Files.createDirectory(folder.resolve("merged")));
        Files.writeString(merged.runs(), "another,table\n");
        IOException refusal = assertThrows(IOException.class, () -> new CampaignMerge(List.of(whole)).writeTo(merged));
        assertTrue(refusal.getMessage().contains("would replace or delete this file"), refusal.getMessage());
        assertEquals("another,table\n", Files.readString(merged.runs()));
        Files.write(merged.runs(), expected);
        new CampaignMerge(List.of(whole)).writeTo(merged);
        assertArrayEquals(expected, Files.readAllBytes(merged.runs()));
    }

    @Test
    void aPartThatAnotherProgramHasChangedIsRefused() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = part(2);
        CampaignFolder three = part(3);
        Files.writeString(three.runs(), Files.readString(three.runs()).replace("\n", "\r\n"));
        cannotMerge(three.runs() + ":1: this is not the header of the campaign", one, two, three);
    }

    @Test
    void aRowThatAnotherProgramHasChangedIsNamed() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = part(2);
        CampaignFolder three = part(3);
        List<String> rows = new ArrayList<>(Files.readAllLines(two.runs()));
        rows.set(2, rows.get(2).replaceFirst(",undecided,", ",undecidd,"));
        Files.write(two.runs(), rows);
        cannotMerge(two.runs() + ":3: outcome is \"undecidd\"; expected one of collided", one, two, three);
    }

    /** A spreadsheet may have saved it in the encoding of the system. */
    @Test
    void aRowThatIsNotUtf8IsNamedAndNotChanged() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = part(2);
        CampaignFolder three = part(3);
        String table = Files.readString(two.runs()).replaceFirst(",room,", ",r\u00f6\u00f6m,");
        assertTrue(table.contains("r\u00f6\u00f6m"), table);
        Files.writeString(two.runs(), table, StandardCharsets.ISO_8859_1);
        cannotMerge(two.runs() + ":2: the file cannot be read as UTF-8 text", one, two, three);
    }

    @Test
    void aRowOfAnotherRunIsNamed() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = part(2);
        CampaignFolder three = part(3);
        List<String> rows = new ArrayList<>(Files.readAllLines(one.runs()));
        String first = rows.remove(1);
        Files.write(one.runs(), rows);
        cannotMerge(one.runs() + ":2: run is \"1\"; expected 0", one, two, three);
        rows.add(1, first);
        rows.add(first.replaceFirst("\\d+", String.valueOf(rows.size() - 1)));
        Files.write(one.runs(), rows);
        cannotMerge(one.runs() + ":" + rows.size() + ": there is a row after that of the last run", one, two, three);
    }

    /** The times belong to no result. */
    @Test
    void aPartWithoutATableOfTimesIsMerged() throws Exception {
        CampaignFolder one = part(1);
        CampaignFolder two = part(2);
        CampaignFolder three = part(3);
        CampaignFolder merged = new CampaignFolder(folder.resolve("merged"));
        Files.delete(one.timing());
        Files.writeString(two.timing(), "");
        String times = Files.readString(three.timing());
        Files.writeString(three.timing(), "run,seconds\n");
        cannotMerge(three.timing() + ":1: this is not the header of the campaign", one, two, three);
        Files.writeString(three.timing(), times);
        new CampaignMerge(List.of(one, two, three)).writeTo(merged);
        assertArrayEquals(expected, Files.readAllBytes(merged.runs()));
        assertEquals(times, Files.readString(merged.timing()));
    }

    /** Another version of the program may merge the parts. */
    @Test
    void theManifestOfAMergeNamesTheProgramOfTheParts() throws Exception {
        List<CampaignFolder> parts = List.of(part(1), part(2), part(3));
        String whole = Files.readString(reference.resolve("campaign.json"));
        String earlier = whole.replaceFirst("\"program\": \"[^\"]*\"", "\"program\": \"faultline 0.0.1\"");
        for (int number = 1; number <= 3; number++) {
            String shard = "\"shard\": \"" + number + "/3\"";
            Files.writeString(
                    folder.resolve("part-" + number + "/campaign.json"), earlier.replace("\"shard\": \"1/1\"", shard));
        }
        new CampaignMerge(parts).writeTo(new CampaignFolder(folder.resolve("merged")));
        assertEquals(earlier, Files.readString(folder.resolve("merged/campaign.json")));
    }

    /** Tools that format JSON put each member on its own line, and some sort the members. */
    @Test
    void aPartWhoseManifestWasFormattedIsOfTheSameCampaign() throws Exception {
        List<CampaignFolder> parts = List.of(part(1), part(2), part(3));
        Path manifest = folder.resolve("part-2/campaign.json");
        String formatted = Files.readString(manifest).replaceAll("([{\\[,]) *(?=[\\n{\"])", "$1\n\t");
        Files.writeString(manifest, formatted);
        assertArrayEquals(
                Files.readAllBytes(parts.get(1).runs()), runs(folder.resolve("part-2"), new Shard(2, 3), 1, true));
        assertEquals(formatted, Files.readString(manifest));
        new CampaignMerge(List.of(parts.get(1), parts.get(0), parts.get(2)))
                .writeTo(new CampaignFolder(folder.resolve("merged")));
        assertEquals(
                Files.readString(reference.resolve("campaign.json")),
                Files.readString(folder.resolve("merged/campaign.json")));
    }

    @Test
    void aPartWhoseManifestIsDamagedIsRefused() throws Exception {
        CampaignFolder one = part(1);
        Path manifest = folder.resolve("part-1/campaign.json");
        for (byte[] damaged : List.of(new byte[0], new byte[] {(byte) 0xff, 0, 7})) {
            Files.write(manifest, damaged);
            cannotMerge("campaign.json does not say which part this is", one);
        }
    }

    private CampaignFolder part(int number) throws Exception {
        Path out = folder.resolve("part-" + number);
        runs(out, new Shard(number, 3), 2, false);
        return new CampaignFolder(out);
    }

    private void cannotMerge(String why, CampaignFolder... parts) {
        CampaignFolder out = new CampaignFolder(folder.resolve("merged"));
        IOException refusal = assertThrows(IOException.class, () -> new CampaignMerge(List.of(parts)).writeTo(out));
        assertTrue(refusal.getMessage().contains(why), refusal.getMessage());
        assertTrue(Files.notExists(out.runs()));
    }
}
