package faultline.paint.export;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes PNG images. Unlike {@link ImageIO}, it needs no temporary file and does not hide why writing fails. */
public final class PngImage {

    private PngImage() {}

    /** Writes an image to a stream, which is not closed. */
    public static void write(BufferedImage image, OutputStream out) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(image, "png", stream);
        }
        bytes.writeTo(out);
    }
}
