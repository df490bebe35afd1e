package faultline.engine;

import java.io.Writer;

/** Writes the trace: a CSV row for every tick. */
public final class TraceWriter implements TickObserver {

    /**
     * A trace on a writer, which the caller closes.
     *
     * @param out where the rows go
     */
    public TraceWriter(Writer out) {
    }

    @Override
    public void observe(Simulation simulation) {
        throw new UnsupportedOperationException();
    }
}
