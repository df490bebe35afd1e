package faultline.external;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** The other end of a connection, which notes how many answers it has received before it writes its next line. */
final class WaitingClient extends InputStream {

    private final List<String> lines;
    private final ByteArrayOutputStream received = new ByteArrayOutputStream();
    private final List<Long> answersBefore = new ArrayList<>();

    WaitingClient(String... lines) {
        this.lines = List.of(lines);
    }

    /** Returns the stream for answers, which holds them back until it is flushed. */
    OutputStream answers() {
        return new BufferedOutputStream(received, 1 << 20);
    }

    /** Returns the number of answers that had arrived before each line, and before the end. */
    List<Long> answersBefore() {
        return answersBefore;
    }

    @Override
    public int read() {
        throw new UnsupportedOperationException();
    }

    @Override
    public int read(byte[] bytes, int offset, int length) {
        int sent = answersBefore.size();
        answersBefore.add(received.toString(StandardCharsets.UTF_8).lines().count());
        if (sent == lines.size()) {
            return -1;
        }
        byte[] line = (lines.get(sent) + "\n").getBytes(StandardCharsets.UTF_8);
        System.arraycopy(line, 0, bytes, offset, line.length);
        return line.length;
    }
}
