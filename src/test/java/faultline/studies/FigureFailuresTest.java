package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.paint.surface.SvgTheme;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Figures of which one fails. */
class FigureFailuresTest {

    @TempDir
    private Path folder;

    private void write(Figure... figures) throws IOException {
        Figures.writeAll(folder, SvgTheme.LIGHT, List.of(figures), 2, (done, all) -> {});
    }

    private static void await(CountDownLatch latch) throws IOException {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
    }

    @Test
    @Timeout(60)
    void aFailureIsReportedWhileASlowerFigureIsMade() {
        IOException failure = assertThrows(
                IOException.class,
                () -> write(out -> await(new CountDownLatch(1)), out -> {
                    throw new IOException("no place");
                }));
        assertEquals("no place", failure.getMessage());
    }

    @Test
    @Timeout(60)
    void ifOneFigureFailsTheOthersDoNotTakeTheirPlaces() throws IOException {
        CountDownLatch written = new CountDownLatch(1);
        assertThrows(
                IOException.class,
                () -> write(
                        out -> {
                            out.writeCsv("good", new CsvTable("a"));
                            written.countDown();
                        },
                        out -> {
                            await(written);
                            throw new IOException("no place");
                        }));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(), files.toList());
        }
    }
}
