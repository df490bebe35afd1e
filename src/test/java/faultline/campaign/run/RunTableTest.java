package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.io.MessageException;
import faultline.io.TemporaryFolder;
import faultline.io.WriteProblem;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tables that are continued, or cannot be written to the end. */
class RunTableTest {

    private static final String HEADER = "run,outcome,wall_share,simulated_s\n";
    private static final String TIMING_HEADER = "run,wall_s,ticks,ticks_per_s\n";
    private static final String ROW = "0,lost,,1\n";

    private static final RunTable.RowRule RULE =
            (cells, run) -> RowCheck.findProblem(Csv.cells(HEADER.strip()), cells, run);

    @TempDir
    Path folder;

    /** A closed file represents any file that cannot be written. */
    @Test
    void aRowThatCannotBeWrittenIsReportedWithTheNameOfItsTable() throws IOException {
        RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 1);
        table.close();
        table.add(new RunMaker.MadeRun(0, ROW, false, 100, 0.5));
        MessageException e = assertThrows(MessageException.class, table::flush);
        assertEquals(folder.resolve("timing.csv") + ": the file cannot be written completely", e.getMessage());
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "open files cannot be deleted")
    void aFolderThatIsDeletedMeanwhileIsReported() throws IOException {
        Path deleted = Files.createDirectory(folder.resolve("deleted"));
        RunTable table = new RunTable(new CampaignFolder(deleted), HEADER, RULE, 0, 1);
        table.add(new RunMaker.MadeRun(0, ROW, false, 100, 0.5));
        TemporaryFolder.deleteTree(deleted);
        MessageException e = assertThrows(MessageException.class, table::close);
        assertEquals(deleted.resolve("timing.csv") + ": its folder does not exist", e.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"runs.csv", "timing.csv"})
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "open files cannot be deleted")
    void aTableThatIsDeletedMeanwhileIsReported(String name) throws IOException {
        RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 1);
        table.add(new RunMaker.MadeRun(0, ROW, false, 100, 0.5));
        Files.delete(folder.resolve(name));
        MessageException e = assertThrows(MessageException.class, table::close);
        assertTrue(e.getMessage().startsWith(folder.resolve(name) + ": "), e.getMessage());
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "the open files are listed in /proc")
    void aTableThatCannotBeOpenedLeavesNoFileOpen() throws IOException {
        Files.createSymbolicLink(folder.resolve("timing.csv"), folder.resolve("no/such/folder"));
        assertThrows(IOException.class, () -> new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 1));
        try (Stream<Path> open = Files.list(Path.of("/proc/self/fd"))) {
            assertEquals(List.of(), open.filter(link -> leadsInto(folder, link)).toList());
        }
    }

    private static boolean leadsInto(Path folder, Path link) {
        try {
            return Files.readSymbolicLink(link).startsWith(folder);
        } catch (IOException closed) {
            return false;
        }
    }

    @Test
    void aFullDiskIsToldFromOtherReasons() {
        Path file = Path.of("runs.csv");
        assertEquals(reason(WriteProblem.DISK_FULL), of(file, "No space left on device"));
        assertEquals(reason(WriteProblem.DISK_FULL), of(file, "Disk quota exceeded"));
        assertEquals(reason(WriteProblem.BROKEN_PIPE), of(file, "Broken pipe"));
        assertEquals(reason(WriteProblem.INTERRUPTED), of(file, null));
    }

    private static String reason(WriteProblem problem) {
        return "runs.csv: " + problem.english();
    }

    private static String of(Path file, String system) {
        return MessageException.ofWriting(file, new IOException(system)).getMessage();
    }

    /** A spreadsheet may have saved the table with other line ends; its rows can take days to make. */
    @ParameterizedTest
    @ValueSource(strings = {"\r\n", "\r"})
    void aTableWithAnotherHeaderIsRefusedAndKept(String lineEnd) throws IOException {
        String changed = (HEADER + ROW).replace("\n", lineEnd);
        Path file = Files.writeString(folder.resolve("runs.csv"), changed);
        IOException e =
                assertThrows(IOException.class, () -> new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 2));
        assertEquals(
                file + ":1: this is not the header of the campaign; restore the table, or remove it", e.getMessage());
        assertEquals(changed, Files.readString(file));
    }

    @Test
    void ofARunThatIsInTheTableOfTimesTwiceOnlyTheFirstRowIsKept() throws IOException {
        Files.writeString(folder.resolve("runs.csv"), HEADER + "0,lost,,1\n1,lost,,1\n");
        Path timing = folder.resolve("timing.csv");
        String good = TIMING_HEADER + "0,0.5,100,200\n";
        Files.writeString(timing, good + "0,0.5,100,200\n1,0.5,100,200\n");
        new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 2).close();
        assertEquals(good, Files.readString(timing));
    }

    /** This part ends before run 3. Some editors leave an empty line at the end. */
    @ParameterizedTest
    @ValueSource(strings = {"", "\n", "\r\n\n", " ", "\0\0", "\n\0"})
    void ofTheRowsOfAnEarlierProcessThoseThatFailedCount(String rest) throws IOException {
        Path file = folder.resolve("runs.csv");
        String good = HEADER + "0,broken,,\n1,lost,,1\n2,lost,,1\n";
        Files.writeString(file, good + rest);
        Path timing = folder.resolve("timing.csv");
        String timed = TIMING_HEADER + "1,0.5,100,200\n2,0.5,100,200\n";
        Files.writeString(timing, timed + "3,0.5,100,200\n");
        try (RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 3)) {
            assertEquals(3, table.next());
            assertEquals(1, table.broken());
        }
        assertEquals(good, Files.readString(file));
        assertEquals(timed, Files.readString(timing));
    }

    /** A table of other runs may have been appended, or the sums of the columns. */
    @ParameterizedTest
    @ValueSource(strings = {"1,broken,,\n", "3,lost,,1\n4,lost,,1\n", "sum,"})
    void aTableWithMoreRowsThanRunsIsRefusedAndKept(String more) throws IOException {
        String changed = HEADER + "1,lost,,1\n2,lost,,1\n\n" + more;
        Path file = Files.writeString(folder.resolve("runs.csv"), changed);
        IOException e =
                assertThrows(IOException.class, () -> new RunTable(new CampaignFolder(folder), HEADER, RULE, 1, 3));
        assertEquals(file + ":5: there is a row after that of the last run; expected 2 rows", e.getMessage());
        assertEquals(changed, Files.readString(file));
    }

    /** Rows can take days to make. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "2,lost,,1 | run is \"2\"; expected 1",
                "01,lost,,1 | run is \"01\"; expected 1",
                "1,tired,,1 | outcome is \"tired\"; expected one of",
                "1,lost | the row has 2 cells; expected 4 like the header"
            })
    void aTableWithAWrongRowIsRefusedAndKept(String row, String problem) throws IOException {
        String changed = HEADER + ROW + row + "\n2,lost,,1\n";
        Path file = Files.writeString(folder.resolve("runs.csv"), changed);
        IOException e =
                assertThrows(IOException.class, () -> new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 9));
        assertTrue(e.getMessage().startsWith(file + ":3: " + problem), e.getMessage());
        assertTrue(e.getMessage()
                .endsWith("; restore the table, or delete this row and those below to make their" + " runs again"));
        assertEquals(changed, Files.readString(file));
    }

    /** No crash leaves a single zero before other rows. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1,lo~st,,1 | the row has a byte of zero",
                "~,lost,,1 | the row has a byte of zero",
                "1,lost,,#1 | the row is too long; expected at most 1 MiB"
            })
    void aTableWithARowThatNoProcessLeavesIsRefusedAndKept(String row, String problem) throws IOException {
        String damaged = row.replace('~', '\0').replace("#", "1".repeat(LineReader.MAX_LENGTH));
        String changed = HEADER + ROW + damaged + "\n2,lost,,1\n";
        Path file = Files.writeString(folder.resolve("runs.csv"), changed);
        IOException e =
                assertThrows(IOException.class, () -> new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 9));
        assertEquals(
                file + ":3: " + problem
                        + "; restore the table, or delete this row and those below to make their runs again",
                e.getMessage());
        assertEquals(changed, Files.readString(file));
    }

    /** Where blocks of the file were not yet on the disk, a crash of the machine leaves zeros. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1,lost,,1 | 0 |",
                "1,lo | 0 |",
                "1,lost | 60 |",
                "1,lost,,1/ | 3000000 |",
                "1,lost | 512 | t,,1/2,lost,,1/",
                "1,lost,,1/ | 1536 | ,,1/4,lost,,1/",
                "1,lo | 4096 | /2,lost,,1/"
            })
    void anIncompleteRowEndsTheTable(String written, int zerosEnd, String below) throws IOException {
        Path file = folder.resolve("runs.csv");
        String before = HEADER + ROW + written.replace('/', '\n');
        String after = below == null ? "" : below.replace('/', '\n');
        Files.writeString(file, before + "\0".repeat(Math.max(0, zerosEnd - before.length())) + after);
        long whole = written.endsWith("/") ? 2 : 1;
        String rows = whole == 2 ? ROW + "1,lost,,1\n" : ROW;
        try (RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 9)) {
            assertEquals(whole, table.next());
            table.add(new RunMaker.MadeRun(whole, whole + ",stopped,,1\n", false, 100, 0.5));
        }
        assertEquals(HEADER + rows + whole + ",stopped,,1\n", Files.readString(file));
    }

    @Test
    void anIncompleteHeaderIsWrittenAgain() throws IOException {
        Files.writeString(folder.resolve("runs.csv"), "run,outc\0\0");
        Files.writeString(folder.resolve("timing.csv"), "run,wal");
        new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 1).close();
        assertEquals(HEADER, Files.readString(folder.resolve("runs.csv")));
        assertEquals(TIMING_HEADER, Files.readString(folder.resolve("timing.csv")));
    }

    @Test
    void rowsThatWereFlushedAreThereWithoutACloseAndTheOthersAfterIt() throws IOException {
        String rows = HEADER + ROW + "1,broken,,\n";
        String times = TIMING_HEADER + "0,0.500000,100,200\n1,0.000000,0,0\n";
        try (RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 3)) {
            table.add(new RunMaker.MadeRun(0, ROW, false, 100, 0.5));
            table.add(new RunMaker.MadeRun(1, "1,broken,,\n", true, 0, 0));
            assertEquals(HEADER, Files.readString(folder.resolve("runs.csv")));
            table.flush();
            assertEquals(rows, Files.readString(folder.resolve("runs.csv")));
            assertEquals(times, Files.readString(folder.resolve("timing.csv")));
            table.add(new RunMaker.MadeRun(2, "2,lost,,1\n", false, 100, 0.5));
            assertEquals(1, table.broken());
        }
        assertEquals(rows + "2,lost,,1\n", Files.readString(folder.resolve("runs.csv")));
        assertEquals(times + "2,0.500000,100,200\n", Files.readString(folder.resolve("timing.csv")));
    }

    @Test
    void aRowOfTimesHasTheTicksPerSecond() throws IOException {
        try (RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 0, 2)) {
            table.add(new RunMaker.MadeRun(0, ROW, false, 1000, 2.5));
            table.add(new RunMaker.MadeRun(1, "1,broken,,\n", true, 0, 0));
            assertEquals(1, table.broken());
        }
        assertEquals(
                TIMING_HEADER + "0,2.500000,1000,400\n1,0.000000,0,0\n",
                Files.readString(folder.resolve("timing.csv")));
    }

    @Test
    void aRunOutOfOrderIsRefused() throws IOException {
        try (RunTable table = new RunTable(new CampaignFolder(folder), HEADER, RULE, 1, 3)) {
            assertEquals(1, table.next());
            assertThrows(IllegalStateException.class, () -> table.add(new RunMaker.MadeRun(2, ROW, false, 100, 0.5)));
        }
    }
}
