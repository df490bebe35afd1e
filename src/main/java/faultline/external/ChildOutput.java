package faultline.external;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.locks.LockSupport;

/**
 * The standard output of a child, in lines. One thread polls it and never blocks in a read. The number of available
 * bytes does not show the end of the stream, so after a while without output another thread reads one byte, which
 * blocks until a byte or the end comes. Until then the polling thread does not touch the stream, whose lock the read
 * holds.
 */
final class ChildOutput {

    /** How often, and every how many nanoseconds, the end of a child's output is looked for. */
    private static final int LOOKS = 50;

    private static final long LOOK_PERIOD = 10_000_000;

    private final InputStream in;
    private final LineBuffer lines = new LineBuffer();
    /** The read that is under way, or null. */
    private FutureTask<Integer> read;

    private boolean ended;

    ChildOutput(InputStream in) {
        this.in = in;
    }

    /** Returns the next whole line without its break, or null if it is not there yet. */
    String next() throws ProtocolException {
        return lines.next();
    }

    /** Takes over what has come. Returns false if nothing has. */
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

    /** Starts the read that finds the end, unless it is under way or has found it. */
    void lookForEnd() {
        if (read == null && !ended) {
            read = new FutureTask<>(in::read);
            ChildProcess.startDaemon("faultline-child-end", read);
        }
    }

    /** Returns whether the child has closed its output, and everything before that was taken over. */
    boolean hasEnded() {
        return ended;
    }

    /** Returns whether part of a line has come. */
    boolean hasPart() {
        return lines.hasPart();
    }

    /**
     * Returns whether there is something to take over from a child that runs no more. A read that is under way finds a
     * byte or the end soon, unless a descendant of the child keeps the pipe open.
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
