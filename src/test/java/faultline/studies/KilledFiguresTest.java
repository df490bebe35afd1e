package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.paint.surface.SvgTheme;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Processes that are killed at random moments while they write figures: each file is the whole old one or the whole new
 * one. The system property {@code faultline.kills} sets how many.
 */
class KilledFiguresTest {

    private static final long WRITING_MILLIS = 400;

    @TempDir
    private Path folder;

    /** Writes figures in light and dark colours in turn, until it is killed. */
    static final class FiguresLoop {

        private FiguresLoop() {}

        public static void main(String[] args) throws IOException {
            Path out = Path.of(args[0]);
            write(out, SvgTheme.LIGHT);
            System.out.println("written");
            while (true) {
                write(out, SvgTheme.DARK);
                write(out, SvgTheme.LIGHT);
            }
        }
    }

    /** Writes the figures that take little time. */
    private static void write(Path out, SvgTheme colours) throws IOException {
        List<Figure> figures = Figures.allFigures().stream()
                .filter(figure -> figure instanceof DriveMotions
                        || figure instanceof PoseAndReferenceFrames
                        || figure instanceof StateDiagramFigure
                        || figure instanceof StepResponse)
                .toList();
        Figures.writeAll(out, colours, figures, 2, (done, all) -> {});
    }

    private static List<Path> files(Path out) throws IOException {
        try (Stream<Path> files = Files.list(out)) {
            return files.sorted().toList();
        }
    }

    private static List<String> names(Path out) throws IOException {
        return files(out).stream().map(file -> file.getFileName().toString()).toList();
    }

    @Test
    void killedFiguresAreWholeOldFilesOrWholeNewOnes() throws Exception {
        Path light = folder.resolve("light");
        Path dark = folder.resolve("dark");
        Path killed = folder.resolve("killed");
        write(light, SvgTheme.LIGHT);
        write(dark, SvgTheme.DARK);
        int temporary = 0;
        for (int i = 0; i < JavaProcess.KILLS; i++) {
            Process process = JavaProcess.startAndAwaitOutput(FiguresLoop.class.getName(), List.of("" + killed));
            assertTrue(JavaProcess.killWithin(WRITING_MILLIS, process));
            for (Path file : files(killed)) {
                if (file.toString().endsWith(".tmp")) {
                    temporary++;
                } else {
                    assertOneOf(light.resolve(file.getFileName()), dark.resolve(file.getFileName()), file);
                }
                // Lets what was left behind look older than it is.
                Files.setLastModifiedTime(file, FileTime.fromMillis(1));
            }
        }
        System.out.println(
                "figures: killed " + JavaProcess.KILLS + " times, " + temporary + " temporary files left in between");
        write(killed, SvgTheme.LIGHT);
        assertEquals(names(light), names(killed));
    }

    /** SIGTERM, unlike {@code kill -9}, lets the moves end that have begun. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void figuresThatAreEndedBySigtermAreAllOldOrAllNew() throws Exception {
        Path light = folder.resolve("light");
        Path dark = folder.resolve("dark");
        Path ended = folder.resolve("ended");
        write(light, SvgTheme.LIGHT);
        write(dark, SvgTheme.DARK);
        for (int i = 0; i < JavaProcess.KILLS; i++) {
            Process process = JavaProcess.startAndAwaitOutput(FiguresLoop.class.getName(), List.of("" + ended));
            assertTrue(JavaProcess.terminateWithin(WRITING_MILLIS, process));
            assertTrue(
                    contents(ended).equals(contents(light)) || contents(ended).equals(contents(dark)));
        }
    }

    /** Writes figures to a new folder, and then waits without a commit. */
    static final class WaitingFigures {

        private WaitingFigures() {}

        public static void main(String[] args) throws Exception {
            try (FigureFolder figures = FigureFolder.create(Path.of(args[0]), SvgTheme.LIGHT)) {
                figures.writeCsv("table", new CsvTable("a"));
                System.out.println("written");
                Thread.sleep(600_000);
            }
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "a process cannot be asked to end")
    void newFoldersAreDeletedBySigterm() throws Exception {
        Process process = JavaProcess.startAndAwaitOutput(
                WaitingFigures.class.getName(), List.of("" + folder.resolve("new/deep/er")));
        assertTrue(Files.exists(folder.resolve("new/deep/er")));
        process.destroy();
        process.waitFor();
        assertEquals(List.of(), files(folder));
    }

    private static Map<String, ByteBuffer> contents(Path out) throws IOException {
        Map<String, ByteBuffer> contents = new TreeMap<>();
        for (Path file : files(out)) {
            contents.put(file.getFileName().toString(), ByteBuffer.wrap(Files.readAllBytes(file)));
        }
        return contents;
    }

    private static void assertOneOf(Path one, Path other, Path file) throws IOException {
        byte[] found = Files.readAllBytes(file);
        assertTrue(
                Arrays.equals(found, Files.readAllBytes(one)) || Arrays.equals(found, Files.readAllBytes(other)),
                () -> file + ": " + found.length + " bytes");
    }
}
