package faultline.app.figures;

import faultline.paint.plot.Appearance;
import faultline.paint.plot.SvgDrawing;
import faultline.scenario.AtomicFile;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/**
 * Where figures go.
 *
 * @param path an existing folder
 * @param appearance of the pictures
 */
record FigureFolder(Path path, Appearance appearance) {

    /** The folder of a path, made where it is not there. */
    static FigureFolder at(Path path, Appearance appearance) throws IOException {
        return new FigureFolder(Files.createDirectories(path), appearance);
    }

    /** Writes a picture. */
    void svg(String name, SvgDrawing drawing) throws IOException {
        write(name + ".svg", drawing.toFile(appearance));
    }

    /** Writes a table. */
    void csv(String name, Table table) throws IOException {
        write(name + ".csv", table.toFile());
    }

    /** Writes pixels. What letters look like hangs on the machine's fonts, so these files may differ from one machine to another. */
    void png(String name, BufferedImage image) throws IOException {
        try (AtomicFile file = AtomicFile.create(path.resolve(name + ".png"))) {
            ImageIO.write(image, "png", file.stream());
            file.commit();
        }
    }

    private void write(String name, String text) throws IOException {
        try (AtomicFile file = AtomicFile.create(path.resolve(name))) {
            file.stream().write(text.getBytes(StandardCharsets.UTF_8));
            file.commit();
        }
    }
}
