package faultline.external;

import faultline.io.MessageText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Splits a stream of bytes into lines of bounded length. */
final class LineBuffer {

    /** The longest line that is read, bytes. */
    private static final int MAX_LINE_BYTES = 1_000_000;

    private byte[] bytes = new byte[8192];
    private int begin;
    private int end;
    /** The index up to which no line break was found. */
    private int searched;

    /**
     * Reads until a line is complete, and returns it without its line break, or null at the end of the stream.
     *
     * @throws ProtocolException if the line is too long or not UTF-8
     */
    String read(InputStream in) throws IOException, ProtocolException {
        String line = next();
        while (line == null) {
            if (!fill(in)) {
                return rest();
            }
            line = next();
        }
        return line;
    }

    /** Reads the available bytes, at least one. Returns false at the end of the stream. */
    boolean fill(InputStream in) throws IOException {
        makeRoom();
        int count = in.read(bytes, end, bytes.length - end);
        end += Math.max(0, count);
        return count >= 0;
    }

    /** Appends a byte that was read. */
    void add(byte value) {
        makeRoom();
        bytes[end++] = value;
    }

    private void makeRoom() {
        if (begin > 0 && end == bytes.length) {
            System.arraycopy(bytes, begin, bytes, 0, end - begin);
            searched -= begin;
            end -= begin;
            begin = 0;
        } else if (end == bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
    }

    /**
     * Returns the next complete line without its line break, or null if it has not arrived yet.
     *
     * @throws ProtocolException if the line is too long or not UTF-8
     */
    String next() throws ProtocolException {
        boolean complete = hasLine();
        if (searched - begin > MAX_LINE_BYTES) {
            throw new ProtocolException(ControllerProblem.LONG_LINE, MAX_LINE_BYTES);
        }
        if (!complete) {
            return null;
        }
        int length = searched - begin;
        if (length > 0 && bytes[searched - 1] == '\r') {
            length--;
        }
        String line = text(begin, length);
        begin = ++searched;
        if (begin == end) {
            begin = 0;
            end = 0;
            searched = 0;
        }
        return line;
    }

    private String text(int from, int length) throws ProtocolException {
        String line = new String(bytes, from, length, StandardCharsets.UTF_8);
        // The replacement character stands for bytes that are not UTF-8, or for itself.
        if (line.indexOf('\uFFFD') >= 0
                && !Arrays.equals(
                        line.getBytes(StandardCharsets.UTF_8), Arrays.copyOfRange(bytes, from, from + length))) {
            throw new ProtocolException(ControllerProblem.NOT_UTF8, MessageText.quoted(line));
        }
        return line;
    }

    /** Returns the last line at the end of a stream, if it has no line break; null if there is none. */
    String rest() throws ProtocolException {
        String line = hasPart() ? text(begin, end - begin) : null;
        begin = end;
        return line;
    }

    /** Returns whether a complete line has arrived. */
    boolean hasLine() {
        while (searched < end && bytes[searched] != '\n') {
            searched++;
        }
        return searched < end;
    }

    /** Returns whether a part of a line has arrived. */
    boolean hasPart() {
        return end > begin;
    }
}
