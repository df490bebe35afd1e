package faultline.io;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

/**
 * Writes a file and forces it to the disk regularly on another thread, so that little remains to be forced when a long
 * file is complete. One thread at a time writes.
 */
final class ForcingOutputStream extends OutputStream {

    /** The file is forced again after this many bytes. */
    private static final int STEP = 8 << 20;

    private final FileChannel channel;
    private final OutputStream out;
    private long unforced;
    private CompletableFuture<Void> forcing = CompletableFuture.completedFuture(null);

    /** Creates a stream to an open file, which it closes. */
    ForcingOutputStream(FileChannel channel) {
        this.channel = channel;
        out = Channels.newOutputStream(channel);
    }

    @Override
    public void write(int b) throws IOException {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        out.write(bytes, offset, length);
        unforced += length;
        if (unforced >= STEP && forcing.isDone()) {
            throwFailure();
            unforced = 0;
            forcing = CompletableFuture.runAsync(this::force);
        }
    }

    private void force() {
        try {
            channel.force(false);
        } catch (IOException e) {
            throw new CompletionException(e);
        }
    }

    /**
     * Waits until the disk has what it is being given, and reports a failure, which the system does only once. Does not
     * force what was written since.
     */
    @Override
    public void flush() throws IOException {
        throwFailure();
    }

    private void throwFailure() throws IOException {
        try {
            forcing.join();
        } catch (CompletionException failed) {
            throw failed.getCause() instanceof IOException e ? e : new IOException(failed.getCause());
        }
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
