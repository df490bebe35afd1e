package faultline.campaign.run;

import faultline.io.MessageException;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Reads a file line by line. Lines include their line feed, so that an incomplete last line is recognised. A line
 * longer than any row of a table is returned in pieces without a line feed, so that a damaged file does not fill the
 * memory.
 */
public final class LineReader implements Closeable {

    /** The maximum length of a line, bytes; a row has a few hundred. */
    static final int MAX_LENGTH = 1 << 20;

    /** File systems write whole blocks, whose sizes are multiples of this, bytes. */
    private static final int BLOCK = 512;

    private final InputStream in;
    /** The last line. */
    private byte[] bytes = {};
    /** The end of the last line, bytes from the beginning of the file. */
    private long position;

    /**
     * Opens a file.
     *
     * @param file the file
     * @throws IOException if the file cannot be opened, or is a device or a pipe, which may have no end
     */
    public LineReader(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new MessageException(file.toString(), ResultsProblem.NOT_REGULAR.with(), null);
        }
        in = new BufferedInputStream(Files.newInputStream(file));
    }

    /**
     * {@return the next line with its line feed; a line at the end of the file or one that is too long may have none;
     * empty at the end}
     *
     * @throws IOException if the file cannot be read
     */
    public String next() throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream(256);
        int c = in.read();
        while (c >= 0 && c != '\n' && line.size() < MAX_LENGTH) {
            line.write(c);
            c = in.read();
        }
        if (c >= 0) {
            line.write(c);
        }
        bytes = line.toByteArray();
        position += bytes.length;
        return new String(bytes, StandardCharsets.UTF_8);
    }

    /** {@return whether the last line is too long to be a row of a table, so that it may be only a part of a line} */
    public boolean isTooLong() {
        return bytes.length > MAX_LENGTH;
    }

    /** Returns the bytes of the last line, which must not be changed. */
    byte[] bytes() {
        return bytes;
    }

    /** Returns whether the last line is UTF-8; in one that is not, other characters replace the wrong bytes. */
    boolean isText() {
        return Arrays.equals(new String(bytes, StandardCharsets.UTF_8).getBytes(StandardCharsets.UTF_8), bytes);
    }

    /** Returns the length of the last line, bytes. */
    int length() {
        return bytes.length;
    }

    /**
     * Returns whether the last line contains zeros that a crash of the machine leaves, up to the end of the file or the
     * beginning of a block that was written. The lines up to there are read.
     */
    boolean hasZerosOfCrash() throws IOException {
        boolean zeros = false;
        for (; bytes.length > 0; next()) {
            for (int i = 0; i < bytes.length; i++) {
                if (zeros && bytes[i] != 0) {
                    return (position - bytes.length + i) % BLOCK == 0;
                }
                zeros |= bytes[i] == 0;
            }
        }
        return zeros;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
