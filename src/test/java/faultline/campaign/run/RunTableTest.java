package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.io.MessageException;
import faultline.io.WriteProblem;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tables that cannot be written to the end. */
class RunTableTest {

    private static final String HEADER = "run,outcome,wall_share,simulated_s\n";
    private static final String ROW = "0,finished,,1\n";

    @TempDir
    Path folder;

    /** A closed file represents any file that cannot be written. */
    @Test
    void aRowThatCannotBeWrittenIsReportedWithTheNameOfItsTable() throws IOException {
        RunTable table = new RunTable(new CampaignFolder(folder), HEADER, 0, 1);
        table.close();
        table.add(new RunMaker.MadeRun(0, ROW, false, 100, 0.5));
        MessageException e = assertThrows(MessageException.class, table::flush);
        assertEquals(folder.resolve("timing.csv") + ": the file cannot be written completely", e.getMessage());
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
    @Test
    void aTableWithAnotherHeaderIsRefusedAndKept() throws IOException {
        String changed = (HEADER + ROW).replace("\n", "\r\n");
        Path file = Files.writeString(folder.resolve("runs.csv"), changed);
        IOException e = assertThrows(IOException.class, () -> new RunTable(new CampaignFolder(folder), HEADER, 0, 2));
        assertEquals(
                file + ":1: this is not the header of the campaign; restore the table, or remove it", e.getMessage());
        assertEquals(changed, Files.readString(file));
    }

    @Test
    void ofARunThatIsInTheTableOfTimesTwiceOnlyTheFirstRowIsKept() throws IOException {
        Files.writeString(folder.resolve("runs.csv"), HEADER + "0,lost,,1\n1,lost,,1\n");
        Path timing = folder.resolve("timing.csv");
        String good = "run,wall_s,ticks,ticks_per_s\n0,0.5,100,200\n";
        Files.writeString(timing, good + "0,0.5,100,200\n1,0.5,100,200\n");
        new RunTable(new CampaignFolder(folder), HEADER, 0, 2).close();
        assertEquals(good, Files.readString(timing));
    }

    @Test
    void rowsThatWereFlushedAreThereWithoutAClose() throws IOException {
        try (RunTable table = new RunTable(new CampaignFolder(folder), HEADER, 0, 1)) {
            table.add(new RunMaker.MadeRun(0, ROW, false, 100, 0.5));
            assertEquals(HEADER, Files.readString(folder.resolve("runs.csv")));
            table.flush();
            assertEquals(HEADER + ROW, Files.readString(folder.resolve("runs.csv")));
        }
    }
}
