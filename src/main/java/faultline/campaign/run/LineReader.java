package faultline.campaign.run;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads a file line by line. Lines include their line feed, so that an incomplete last line is recognised. */
final class LineReader implements Closeable {

    private final InputStream in;
    private int length;

    LineReader(Path file) throws IOException {
        in = new BufferedInputStream(Files.newInputStream(file));
    }

    /** Returns the next line with its line feed, without one only at the end of the file; empty after that. */
    String next() throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream(256);
        int c = in.read();
        while (c >= 0 && c != '\n') {
            line.write(c);
            c = in.read();
        }
        if (c >= 0) {
            line.write(c);
        }
        length = line.size();
        return line.toString(StandardCharsets.UTF_8);
    }

    /** Returns how many bytes the last line had. */
    int length() {
        return length;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
