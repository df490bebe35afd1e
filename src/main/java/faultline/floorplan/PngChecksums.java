package faultline.floorplan;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;

/**
 * The checksums of the chunks of a PNG file. The JDK's reader ignores them, so that it would read a damaged palette as
 * another map.
 */
final class PngChecksums {

    private static final int SIGNATURE_BYTES = 8;
    private static final int TYPE_BYTES = 4;

    /** The chunks that determine the pixels. */
    private static final Set<String> CHECKED = Set.of("IHDR", "PLTE", "tRNS", "IDAT");

    private static final String LAST = "IEND";

    private PngChecksums() {}

    /**
     * Checks a file up to its last whole chunk; whether a truncated file has all its pixels is for the reader to say.
     *
     * @param file the file, for the message
     * @param in the file from its beginning, buffered
     * @throws FloorPlanException if a chunk that determines the pixels does not match its checksum
     */
    static void check(Path file, InputStream in) throws IOException {
        CheckedInputStream checked = new CheckedInputStream(in, new CRC32());
        DataInputStream data = new DataInputStream(checked);
        byte[] name = new byte[TYPE_BYTES];
        try {
            data.skipNBytes(SIGNATURE_BYTES);
            long place = SIGNATURE_BYTES;
            for (String type = ""; !type.equals(LAST); ) {
                long length = Integer.toUnsignedLong(data.readInt());
                checked.getChecksum().reset();
                data.readFully(name);
                data.skipNBytes(length);
                int computed = (int) checked.getChecksum().getValue();
                type = new String(name, StandardCharsets.ISO_8859_1);
                if (data.readInt() != computed && CHECKED.contains(type)) {
                    throw new FloorPlanException(file, FloorPlanProblem.CHECKSUM.with(type, place));
                }
                place += length + TYPE_BYTES + 2 * Integer.BYTES;
            }
        } catch (EOFException truncated) {
            // The reader reports it if pixels are missing.
        }
    }
}
