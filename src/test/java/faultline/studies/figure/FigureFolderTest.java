package faultline.studies.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.paint.surface.SvgTheme;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URI;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files of figures that are links. */
class FigureFolderTest {

    @TempDir
    private Path folder;

    private FigureFolder figures() throws IOException {
        return FigureFolder.create(folder, SvgTheme.LIGHT);
    }

    private static final CsvTable TABLE = new CsvTable("a");

    @ParameterizedTest
    @ValueSource(strings = {"other.csv", "./other.csv", "../figures/other.csv", "missing.csv"})
    void aTableThatIsAnotherFileOfTheFolderByALinkIsRefused(String target) throws IOException {
        folder = Files.createDirectory(folder.resolve("figures"));
        Path other = Files.writeString(folder.resolve("other.csv"), "precious");
        Files.createSymbolicLink(folder.resolve("table.csv"), Path.of(target));
        IOException refusal = assertThrows(IOException.class, () -> figures().writeCsv("table", TABLE));
        assertTrue(
                refusal.getMessage()
                        .endsWith("table.csv: this is a link to another file of the folder; expected a file"),
                refusal.getMessage());
        assertEquals("precious", Files.readString(other));
    }

    @Test
    void anImageThatIsAnotherFileOfTheFolderByALinkIsRefused() throws IOException {
        Files.createSymbolicLink(folder.resolve("image.png"), Path.of("other.png"));
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        assertThrows(IOException.class, () -> figures().writePng("image", image));
    }

    @Test
    void twoTablesThatAreOneFileOutsideOfTheFolderByLinksAreRefused() throws IOException {
        Path outside = Files.writeString(folder.resolve("outside.csv"), "precious");
        folder = Files.createDirectory(folder.resolve("figures"));
        for (String name : List.of("first.csv", "second.csv")) {
            Files.createSymbolicLink(folder.resolve(name), Path.of("../outside.csv"));
        }
        try (FigureFolder figures = figures()) {
            figures.writeCsv("first", TABLE);
            IOException refusal = assertThrows(IOException.class, () -> figures.writeCsv("second", TABLE));
            assertTrue(refusal.getMessage().contains("another output is the same file"), refusal.getMessage());
        }
        assertEquals("precious", Files.readString(outside));
    }

    /** The files of the JDK are a folder that nobody can write to. */
    @Test
    void aFolderThatCannotBeWrittenToIsRefusedAtOnce() {
        Path modules = FileSystems.getFileSystem(URI.create("jrt:/")).getPath("/modules");
        AccessDeniedException refusal =
                assertThrows(AccessDeniedException.class, () -> FigureFolder.create(modules, SvgTheme.LIGHT));
        assertEquals("/modules", refusal.getFile());
    }

    @Test
    void nothingChangesWithoutACommit() throws IOException {
        Path old = Files.writeString(folder.resolve("table.csv"), "old");
        try (FigureFolder figures = figures()) {
            figures.writeCsv("table", TABLE);
            figures.writeCsv("other", TABLE);
            assertEquals("old", Files.readString(old));
        }
        assertEquals(List.of(old), files());
    }

    @Test
    void newFoldersAreDeletedWithoutACommit() throws IOException {
        try (FigureFolder figures = FigureFolder.create(folder.resolve("a/b"), SvgTheme.LIGHT)) {
            figures.writeCsv("table", TABLE);
        }
        assertEquals(List.of(), files());
    }

    @Test
    void newFoldersAreDeletedIfTheirFolderCannotBeCreated() throws IOException {
        Path out = folder.resolve("a/b").resolve("x".repeat(300));
        assertThrows(IOException.class, () -> FigureFolder.create(out, SvgTheme.LIGHT));
        assertEquals(List.of(), files());
    }

    @Test
    void newFoldersStayAfterACommit() throws IOException {
        try (FigureFolder figures = FigureFolder.create(folder.resolve("a/b"), SvgTheme.LIGHT)) {
            figures.writeCsv("table", TABLE);
            figures.commit();
        }
        assertTrue(Files.exists(folder.resolve("a/b/table.csv")));
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }
}
