package faultline.engine.metrics;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.List;

/**
 * Writes the trace: a header, then a CSV row for tick 0 and after every tick. Numbers are the shortest that read back
 * to the same bits.
 */
public final class TraceWriter implements TickObserver {

    private final OutputStream out;
    private final TraceFormat format;
    private final TraceBlock block = new TraceBlock();
    private List<TraceCells> cells = List.of();

    /**
     * Creates a trace on a stream, which the caller closes.
     *
     * @param out where the rows go, many at a time
     * @param format which columns it has
     */
    public TraceWriter(OutputStream out, TraceFormat format) {
        this.out = out;
        this.format = format;
    }

    /**
     * Adds the row of this moment.
     *
     * @throws UncheckedIOException if the stream fails
     */
    @Override
    public void observe(Simulation simulation) {
        if (cells.isEmpty()) {
            cells = format.cells(simulation.robot());
            cells.forEach(some -> some.columns().forEach(column -> block.append(column.name() + ",")));
            block.endRow();
        }
        for (int i = 0; i < cells.size(); i++) {
            cells.get(i).append(simulation, block);
        }
        block.endRow();
        try {
            block.writeIfLong(out);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /**
     * Writes the rows that have not been written; must be called at the end.
     *
     * @throws IOException if the stream fails
     */
    public void flush() throws IOException {
        block.write(out);
        out.flush();
    }
}
