package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WorstRunsTest {

    @TempDir
    private Path folder;

    private CampaignPlan plan;
    private List<String> header;
    private final List<String> rows = new ArrayList<>();

    @BeforeEach
    void readThePlan() throws Exception {
        plan = SamplePlan.read(
                SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"30\"/>"));
        header = Csv.cells(ResultColumns.header(plan).strip());
        rows.add(ResultColumns.header(plan));
    }

    /** Adds the row of the next run; it passed a share of the wall. */
    private void addRow(String outcome, String share) {
        List<String> cells = new ArrayList<>(Collections.nCopies(header.size(), ""));
        cells.set(header.indexOf("run"), Integer.toString(rows.size() - 1));
        cells.set(header.indexOf("outcome"), outcome);
        cells.set(header.indexOf("wall_share"), share);
        cells.set(header.indexOf("simulated_s"), "1");
        rows.add(Csv.row(cells));
    }

    private List<String> replays() throws IOException {
        Files.writeString(folder.resolve("runs.csv"), String.join("", rows));
        new WorstRuns(plan, new CampaignFolder(folder)).writeReplays();
        return replayNames();
    }

    private List<String> replayNames() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("replays"))) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private static List<String> names(int... runs) {
        return IntStream.of(runs)
                .mapToObj(run -> String.format("run-%07d.xml", run))
                .toList();
    }

    @Test
    void twentyRunsHaveReplaysThoseWithTheWorstOutcomesFirst() throws IOException {
        IntStream.range(0, 6).forEach(i -> addRow("carried_on", "0.9"));
        IntStream.range(6, 11).forEach(i -> addRow("undecided", ""));
        IntStream.range(11, 16).forEach(i -> addRow("stopped", "0.1"));
        IntStream.range(16, 21).forEach(i -> addRow("lost", "0.2"));
        IntStream.range(21, 26).forEach(i -> addRow("collided", "0.9"));
        assertEquals(names(IntStream.range(6, 26).toArray()), replays());
    }

    @Test
    void ofRunsWithOneOutcomeThoseThatPassedLessOfTheWallAreWorse() throws IOException {
        addRow("carried_on", "0.9");
        addRow("carried_on", "0.85");
        addRow("carried_on", "0.85");
        addRow("carried_on", "0.81");
        IntStream.range(4, 22).forEach(i -> addRow("lost", "0.2"));
        assertEquals(
                names(IntStream.concat(IntStream.of(1, 3), IntStream.range(4, 22))
                        .toArray()),
                replays());
    }

    @Test
    void ofRunsWithOneOutcomeThoseWhoseShareIsNotKnownAreTheWorstAndOfEqualOnesTheFirst() throws IOException {
        IntStream.range(0, 22).forEach(i -> addRow("undecided", i == 21 ? "" : "0.2"));
        assertEquals(
                names(IntStream.concat(IntStream.range(0, 19), IntStream.of(21)).toArray()), replays());
    }

    @Test
    void aRunThatFailedHasNoReplay() throws IOException {
        addRow("broken", "");
        addRow("lost", "0.2");
        assertEquals(names(1), replays());
    }

    @Test
    void aRowWithBytesThatAreNotUtf8HasAReplayToo() throws IOException {
        addRow("lost", "0.2");
        String row = rows.get(1);
        List<String> cells = Csv.cells(row.strip());
        cells.set(header.indexOf("collided_with"), "S\u00e4ule");
        Files.write(folder.resolve("runs.csv"), (rows.get(0) + Csv.row(cells)).getBytes(StandardCharsets.ISO_8859_1));
        new WorstRuns(plan, new CampaignFolder(folder)).writeReplays();
        assertEquals(names(0), replayNames());
    }

    @Test
    void aRowThatIsNotOneOfARunIsReportedWithTheNameOfItsTable() {
        addRow("lost", "0.2");
        rows.add("1,lost\n");
        IOException e = assertThrows(IOException.class, this::replays);
        assertEquals(
                folder.resolve("runs.csv") + ":3: the row has 2 cells; expected " + header.size() + " like the header",
                e.getMessage());
    }

    @Test
    void replaysOfAnEarlierTableAreRemovedAndOtherFilesAreKept() throws IOException {
        addRow("lost", "0.2");
        assertEquals(names(0), replays());
        Files.createFile(folder.resolve("replays/notes.txt"));
        rows.remove(1);
        addRow("broken", "");
        addRow("lost", "0.2");
        assertEquals(List.of("notes.txt", "run-0000001.xml"), replays());
    }
}
