package faultline.engine.trace;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Writes the trace: a header, then a CSV row for tick 0 and after every tick. Numbers are the shortest that read back
 * to the same bits.
 *
 * <p>Used by the thread of the run, which only collects values. Another thread converts them to text and writes it, a
 * block of rows at a time; the run waits when a block is full before the last one has been written.
 */
public final class TraceWriter implements TickObserver, AutoCloseable {

    /**
     * Blocks are filled in turn. A block that the other processor has just read is slower to fill than an older one.
     */
    private static final int MAX_BLOCKS = 8;

    private final OutputStream out;
    private final TraceFormat format;
    private final int maxRows;
    private final ExecutorService writer = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "faultline-trace");
        thread.setDaemon(true);
        return thread;
    });

    private List<ColumnGroup> groups = List.of();
    private TraceText text;
    private TraceRows rows;
    /** Blocks that have been handed over, the oldest first; all but the last one have been written. */
    private final Deque<TraceRows> handedOver = new ArrayDeque<>();

    private CompletableFuture<Void> writing = CompletableFuture.completedFuture(null);

    /**
     * Creates a trace on a stream, which the caller closes after this.
     *
     * @param out the target of the rows, written in blocks on another thread
     * @param format the format, which defines the columns
     */
    public TraceWriter(OutputStream out, TraceFormat format) {
        this(out, format, Integer.MAX_VALUE);
    }

    /**
     * Creates a trace whose rows are written without delay even if the run is slow.
     *
     * @param out the target of the rows, written in blocks on another thread
     * @param format the format, which defines the columns
     * @param maxRows the maximum number of rows that are written at a time, at least 1
     */
    public TraceWriter(OutputStream out, TraceFormat format, int maxRows) {
        this.out = out;
        this.format = format;
        this.maxRows = maxRows;
    }

    /**
     * Adds the row of this moment.
     *
     * @throws UncheckedIOException if the stream has failed
     */
    @Override
    public void observe(Simulation simulation) {
        if (groups.isEmpty()) {
            begin(simulation);
        }
        for (int i = 0; i < groups.size(); i++) {
            groups.get(i).append(simulation, rows);
        }
        rows.endRow();
        if (rows.isFull()) {
            handOver();
        }
    }

    private void begin(Simulation simulation) {
        groups = format.groups(simulation.robot());
        List<String> header = new ArrayList<>();
        for (ColumnGroup group : groups) {
            for (TraceColumn column : group.columns()) {
                header.add(column.name());
            }
        }
        text = new TraceText(header.size());
        text.append(header);
        rows = new TraceRows(header.size(), maxRows);
    }

    private void handOver() {
        throwFailure();
        TraceRows full = rows;
        handedOver.add(full);
        if (handedOver.size() < MAX_BLOCKS) {
            rows = full.next();
        } else {
            rows = handedOver.remove();
            rows.clear();
        }
        writing = CompletableFuture.runAsync(() -> write(full), writer);
    }

    /** Waits until the rows that were handed over have been written. */
    private void throwFailure() {
        try {
            writing.join();
        } catch (CompletionException failed) {
            throw failed.getCause() instanceof UncheckedIOException e ? e : failed;
        }
    }

    private void write(TraceRows block) {
        try {
            text.write(block, out);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /**
     * Writes the rows that have not been written, and flushes the stream; must be called at the end. Rows can be added
     * after that.
     *
     * @throws IOException if the stream fails
     */
    public void flush() throws IOException {
        try {
            throwFailure();
            if (!groups.isEmpty()) {
                write(rows);
                rows.clear();
            }
        } catch (UncheckedIOException failed) {
            throw failed.getCause();
        }
        out.flush();
    }

    /** Ends the thread of the trace without using the stream; rows that have not been written are lost. */
    @Override
    public void close() {
        writer.shutdown();
        writing.handle((done, failed) -> null).join();
    }
}
