package faultline.engine.metrics;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Writes the trace: a header, then a CSV row for tick 0 and after every tick. Numbers are the shortest that read back
 * to the same bits.
 */
public final class TraceWriter implements TickObserver {

    private final Writer out;
    private final TraceFormat format;
    private final TraceRow row = new TraceRow();
    private List<TraceColumn> columns = List.of();

    /**
     * Creates a trace on a writer, which the caller closes.
     *
     * @param out where the rows go; buffered
     * @param format which columns it has
     */
    public TraceWriter(Writer out, TraceFormat format) {
        this.out = out;
        this.format = format;
    }

    /**
     * Writes the row of this moment.
     *
     * @throws UncheckedIOException if the writer fails
     */
    @Override
    public void observe(Simulation simulation) {
        if (columns.isEmpty()) {
            columns = format.columns(simulation.robot());
            row.append(columns.stream().map(TraceColumn::name).collect(Collectors.joining(",", "", "\n")));
        }
        for (int i = 0; i < columns.size(); i++) {
            if (i > 0) {
                row.append(',');
            }
            columns.get(i).cell().accept(simulation, row);
        }
        row.append('\n');
        try {
            row.writeTo(out);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
