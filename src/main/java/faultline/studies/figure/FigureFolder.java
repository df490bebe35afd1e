package faultline.studies.figure;

import faultline.io.AtomicFileGroup;
import faultline.io.LinkResolver;
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
import java.util.List;
import java.util.stream.Stream;

/**
 * A folder for figures, and the appearance of the pictures. The files take their places together when all are written;
 * without a commit nothing changes, and a new folder is deleted again. Several threads may write at the same time.
 */
public final class FigureFolder implements AutoCloseable {

    private final Path path;
    private final SvgTheme appearance;
    private final AtomicFileGroup files = new AtomicFileGroup();

    /** The folders that did not exist before, innermost first. */
    private final List<Path> created;

    private FigureFolder(Path path, List<Path> created, SvgTheme appearance) {
        this.path = path;
        this.created = created;
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
                .takeWhile(folder -> folder != null && Files.notExists(folder))
                .toList();
        return new FigureFolder(Files.createDirectories(path), missing, appearance);
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
        files.close();
        try {
            for (Path folder : created) {
                Files.delete(folder);
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
