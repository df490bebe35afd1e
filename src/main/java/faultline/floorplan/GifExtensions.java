package faultline.floorplan;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * The extensions of a GIF file before its image, such as comments. The JDK's reader takes a time that grows with the
 * square of their length, even if it ignores them.
 */
final class GifExtensions {

    /** The bytes of the signature and of the description of the screen. */
    private static final int HEADER_BYTES = 13;

    private static final int EXTENSION = 0x21;
    /** The label of the extension that says which colour is transparent. */
    private static final int CONTROL = 0xf9;

    /** The bytes of this extension after its label. */
    private static final int CONTROL_BYTES = 6;

    private GifExtensions() {}

    /**
     * Returns a file from its first image on, after the header and the last extension about transparency.
     *
     * @param in the file from its beginning, buffered; it must stay open
     */
    static ImageInputStream skip(InputStream in) throws IOException {
        ByteArrayOutputStream start = new ByteArrayOutputStream();
        byte[] header = in.readNBytes(HEADER_BYTES);
        start.write(header);
        if (header.length == HEADER_BYTES && (header[10] & 0x80) != 0) {
            start.write(in.readNBytes(3 << (header[10] & 7) + 1));
        }
        byte[] control = {};
        int next = in.read();
        while (next == EXTENSION) {
            int label = in.read();
            if (label == CONTROL) {
                control = in.readNBytes(CONTROL_BYTES);
            } else {
                skipBlocks(in);
            }
            next = in.read();
        }
        if (control.length > 0) {
            start.write(EXTENSION);
            start.write(CONTROL);
            start.write(control);
        }
        if (next >= 0) {
            start.write(next);
        }
        return new MemoryCacheImageInputStream(
                new SequenceInputStream(new ByteArrayInputStream(start.toByteArray()), in));
    }

    private static void skipBlocks(InputStream in) throws IOException {
        for (int length = in.read(); length > 0; length = in.read()) {
            in.skipNBytes(length);
        }
    }
}
