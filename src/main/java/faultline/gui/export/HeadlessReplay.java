package faultline.gui.export;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

/** The run so far made once more, to the bit and without a window, for whoever has to see each of its ticks. */
final class HeadlessReplay {

    private final SimulationSetup setup;

    private HeadlessReplay(SimulationSetup setup) {
        this.setup = setup;
    }

    /** Waits until the run says what was done to it so far. */
    static HeadlessReplay of(CompletableFuture<Scenario> run) throws IOException {
        try {
            return new HeadlessReplay(run.join().setup());
        } catch (CompletionException closed) {
            throw new IOException(closed.getCause().getMessage(), closed);
        }
    }

    SimulationSetup setup() {
        return setup;
    }

    /** Something that looks at a tick and writes. */
    interface TickWriter {
        void write(Simulation simulation) throws IOException;
    }

    /** Makes every tick, tick 0 included, and tells how far it is. */
    void run(TickWriter writer, ProgressListener progress) throws IOException {
        double ticks = Math.max(1, setup.ticks());
        try {
            HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(simulation -> {
                progress.progressed(simulation.ticks() / ticks);
                write(writer, simulation);
            }));
        } catch (UncheckedIOException failed) {
            throw failed.getCause();
        }
    }

    private static void write(TickWriter writer, Simulation simulation) {
        try {
            writer.write(simulation);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
