package faultline.gui.export;

import faultline.engine.metrics.TraceWriter;
import faultline.gui.document.TaskProgress;
import faultline.scenario.Scenario;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;

/**
 * Writes one row for every tick of the run so far, as {@code run --trace} does.
 *
 * @param run completes with the scenario that replays the run
 */
record TraceExport(CompletableFuture<Scenario> run) implements FileExport {

    @Override
    public void write(OutputStream out, TaskProgress progress) throws IOException {
        Writer text = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
        TraceWriter trace = new TraceWriter(text);
        HeadlessReplay.run(run, trace::observe, progress);
        text.flush();
    }
}
