package faultline.studies.figure;

import faultline.io.AtomicFile;
import faultline.io.AtomicFileGroup;
import faultline.io.LinkResolver;
import faultline.io.ShutdownHooks;
import faultline.paint.chart.Chart;
import faultline.paint.export.PngImage;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.SvgSurface;
import faultline.paint.surface.SvgTheme;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.stream.Stream;

/**
 * A folder for figures, and the appearance of the pictures. The files take their places together when all are written;
 * without a commit nothing changes, and new folders are deleted again, also if a signal ends the process. Several
 * threads may write at the same time.
 */
public final class FigureFolder implements AutoCloseable {

    private final Path path;
    private final SvgTheme appearance;
    private final AtomicFileGroup files = new AtomicFileGroup();

    /** The folders that did not exist before, innermost first. */
    private final Deque<Path> created = new ConcurrentLinkedDeque<>();

    private final Thread deletionAtEnd = new Thread(this::deleteWhileEnding, "delete new folders");

    private FigureFolder(Path path, SvgTheme appearance) {
        this.path = path;
        this.appearance = appearance;
    }

    /**
     * Returns the folder at a path, which is created if necessary. A folder that cannot be written to is refused at
     * once, not after the first figure has been computed.
     */
    public static FigureFolder create(Path path, SvgTheme appearance) throws IOException {
        if (Files.isDirectory(path) && !Files.isWritable(path)) {
            throw new AccessDeniedException(path.toString());
        }
        List<Path> missing = Stream.iterate(path.toAbsolutePath(), Path::getParent)
                .takeWhile(folder -> folder != null && !Files.exists(folder))
                .toList();
        FigureFolder folder = new FigureFolder(path, appearance);
        ShutdownHooks.add(folder.deletionAtEnd);
        try {
            folder.createFolders(missing);
        } catch (IOException e) {
            folder.close();
            throw e;
        }
        return folder;
    }

    /** Creates the folders that are missing, given innermost first. */
    private void createFolders(List<Path> missing) throws IOException {
        for (int i = missing.size() - 1; i >= 0; i--) {
            Files.createDirectories(missing.get(i));
            created.addFirst(missing.get(i));
        }
        Files.createDirectories(path);
    }

    /** {@return the appearance of the pictures} */
    public SvgTheme appearance() {
        return appearance;
    }

    /** Writes a picture. */
    public void writeSvg(String name, SvgSurface surface) throws IOException {
        write(name + ".svg", surface.toSvg(appearance));
    }

    public void writeCsv(String name, CsvTable table) throws IOException {
        write(name + ".csv", table.toCsv());
    }

    /** Writes a chart with a caption below it, and the table of its values. */
    public void writeChart(String name, CsvTable table, Chart chart, int width, int height, String caption)
            throws IOException {
        FigureCanvas canvas = new FigureCanvas(width, height, caption);
        canvas.addChart(chart, new PixelRectangle(0, 4, width, height - 8));
        writeSvg(name, canvas.surface());
        writeCsv(name, table);
    }

    /** Writes a bitmap. Its letters depend on the fonts of the machine, so these files may differ between machines. */
    public void writePng(String name, BufferedImage image) throws IOException {
        PngImage.write(image, files.create(target(name + ".png")).stream());
    }

    private void write(String name, String text) throws IOException {
        files.write(target(name), text.getBytes(StandardCharsets.UTF_8));
    }

    /** Moves the written files into place. */
    public void commit() throws IOException {
        files.commit();
    }

    @Override
    public void close() throws IOException {
        ShutdownHooks.remove(deletionAtEnd);
        files.close();
        deleteEmptyFolders();
    }

    private void deleteWhileEnding() {
        AtomicFile.deleteUnfinished();
        try {
            deleteEmptyFolders();
        } catch (IOException e) {
            // The process is ending, so the failure cannot be reported.
        }
    }

    private void deleteEmptyFolders() throws IOException {
        try {
            for (Path folder : created) {
                Files.deleteIfExists(folder);
            }
        } catch (DirectoryNotEmptyException hasFiles) {
            // The figures, or files of another program, are in it.
        }
    }

    /** Returns the path of a file, which must not be a link to another file of the folder. */
    private Path target(String name) throws IOException {
        Path target = path.resolve(name);
        if (Files.isSymbolicLink(target)
                && path.toRealPath().equals(LinkResolver.resolve(target).getParent())) {
            throw new IOException(target + ": this is a link to another file of the folder; expected a file");
        }
        return target;
    }
}
