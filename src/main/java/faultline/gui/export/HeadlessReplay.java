package faultline.gui.export;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.trace.TraceFormat;
import faultline.engine.trace.TraceWriter;
import faultline.gui.document.TaskProgress;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

/** Replays the run so far exactly and without a window, for exports that need every tick. */
final class HeadlessReplay {

    /** Writes the state of a simulation after a tick. */
    @FunctionalInterface
    interface TickWriter {
        void write(Simulation simulation) throws IOException;
    }

    private HeadlessReplay() {}

    /** Makes every tick of a scenario, including tick 0, and reports the progress. Waits for the scenario. */
    static void run(CompletableFuture<Scenario> scenario, TickWriter writer, TaskProgress progress) throws IOException {
        Scenario replayed = join(scenario);
        double ticks = Math.max(1, replayed.setup().ticks());
        try {
            HeadlessRun.run(replayed.setup(), ControllerMode.DIRECT, List.of(simulation -> {
                progress.setFraction(simulation.ticks() / ticks);
                write(writer, simulation);
            }));
        } catch (UncheckedIOException failure) {
            throw failure.getCause();
        }
    }

    /** Writes one row for every tick of a scenario, as {@code run --trace} does. */
    static void writeTrace(CompletableFuture<Scenario> scenario, OutputStream out, TaskProgress progress)
            throws IOException {
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE)) {
            run(scenario, trace::observe, progress);
            trace.flush();
        }
    }

    private static Scenario join(CompletableFuture<Scenario> scenario) throws IOException {
        try {
            return scenario.join();
        } catch (CompletionException closed) {
            throw new IOException(closed.getCause().getMessage(), closed);
        }
    }

    private static void write(TickWriter writer, Simulation simulation) {
        try {
            writer.write(simulation);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
