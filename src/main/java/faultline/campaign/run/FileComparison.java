package faultline.campaign.run;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** A stream that compares what is written to it with a file, without reading the whole file into memory. */
final class FileComparison extends OutputStream {

    private final InputStream file;
    private boolean equal = true;

    /** Opens a file. Throws an exception if it cannot be opened. */
    FileComparison(Path file) throws IOException {
        this.file = new BufferedInputStream(Files.newInputStream(file));
    }

    @Override
    public void write(int value) throws IOException {
        write(new byte[] {(byte) value});
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        byte[] expected = file.readNBytes(length);
        equal = equal && Arrays.equals(expected, 0, expected.length, bytes, offset, offset + length);
    }

    /** Returns whether the file is equal to what was written. Nothing may be written after this. */
    boolean isEqual() throws IOException {
        return equal && file.read() < 0;
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
