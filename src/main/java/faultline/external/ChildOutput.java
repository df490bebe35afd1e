package faultline.external;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.locks.LockSupport;

/**
 * The standard output of a child, in lines. One thread polls it and never blocks in a read. The number of available
 * bytes does not show the end of the stream, so after some time without output another thread reads one byte, which
 * blocks until a byte or the end arrives. Until then the polling thread does not use the stream, because the read holds
 * its lock.
 */
final class ChildOutput {

    /** The number of checks for the end of a child's output, and the nanoseconds between two checks. */
    private static final int LOOKS = 50;

    private static final long LOOK_PERIOD = 10_000_000;

    private final InputStream in;
    private final LineBuffer lines = new LineBuffer();
    /** The read in progress, or null. */
    private FutureTask<Integer> read;

    private boolean ended;

    ChildOutput(InputStream in) {
        this.in = in;
    }

    /** Returns the next complete line without its line break, or null if it has not arrived yet. */
    String next() throws ProtocolException {
        return lines.next();
    }

    /** Returns whether a complete line has arrived. */
    boolean hasLine() throws IOException {
        fill();
        return lines.hasLine();
    }

    /** Reads the bytes that have arrived. Returns false if there are none. */
    boolean fill() throws IOException {
        if (read != null) {
            if (!read.isDone()) {
                return false;
            }
            int value = result(read);
            read = null;
            ended = value < 0;
            if (!ended) {
                lines.add((byte) value);
                return true;
            }
        }
        return in.available() > 0 && lines.fill(in);
    }

    private static int result(FutureTask<Integer> done) throws IOException {
        try {
            return done.get();
        } catch (ExecutionException e) {
            throw new IOException(e.getCause().getMessage(), e);
        } catch (InterruptedException e) {
            throw new AssertionError("a task that is done is not waited for", e);
        }
    }

    /** Starts the read that finds the end, unless it is in progress or has found the end. */
    void lookForEnd() {
        if (read == null && !ended) {
            read = new FutureTask<>(in::read);
            ChildProcess.startDaemon("faultline-child-end", read);
        }
    }

    /** Returns whether the child has closed its output and everything before the end was read. */
    boolean hasEnded() {
        return ended;
    }

    /** Returns whether a part of a line has arrived. */
    boolean hasPart() {
        return lines.hasPart();
    }

    /**
     * Returns whether there is output to read from a child that has ended. A read in progress soon finds a byte or the
     * end, unless a descendant of the child keeps the pipe open.
     */
    boolean isLeft() throws IOException {
        if (read == null) {
            return in.available() > 0;
        }
        for (int i = 0; i < LOOKS && !read.isDone(); i++) {
            LockSupport.parkNanos(LOOK_PERIOD);
        }
        return read.isDone();
    }
}
