package faultline.external;

import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;

/** The requests of a client, one a line, of which the next can be read while the last is executed. */
final class RequestLines {

    private final InputStream in;
    private final LineBuffer lines = new LineBuffer();
    /** The line that is being read ahead, otherwise null. */
    private FutureTask<String> next;

    RequestLines(InputStream in) {
        this.in = in;
    }

    /** Returns the next line, or null at the end of the input. */
    String read() throws IOException, ProtocolException {
        if (next == null) {
            return lines.read(in);
        }
        FutureTask<String> ahead = next;
        next = null;
        return result(ahead);
    }

    /** Returns whether the input is known to have ended; the first call only begins to read ahead. */
    boolean isEnded() {
        if (next == null) {
            next = new FutureTask<>(() -> lines.read(in));
            Thread reader = new Thread(next, "faultline-requests");
            reader.setDaemon(true);
            reader.start();
        }
        try {
            return next.isDone() && result(next) == null;
        } catch (IOException | ProtocolException reportedWhenRead) {
            return false;
        }
    }

    private static String result(Future<String> reading) throws IOException, ProtocolException {
        try {
            return reading.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException broken) {
                throw broken;
            }
            if (e.getCause() instanceof ProtocolException wrong) {
                throw wrong;
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException();
        }
    }
}
