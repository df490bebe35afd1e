package faultline.app;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.engine.metrics.TraceWriter;
import faultline.io.AtomicFile;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.PngImage;
import faultline.paint.surface.Palette;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import java.awt.image.BufferedImage;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The output files of a run. All files are opened before the run, so that one that cannot be written is reported at
 * once, and moved into place after it; a failed run leaves no files.
 */
final class RunOutputs implements AutoCloseable {

    private static final int IMAGE_WIDTH = 1200;
    private static final int MIN_HEIGHT = 300;
    private static final int MAX_HEIGHT = 2400;

    private final List<AtomicFile> openFiles = new ArrayList<>();
    private final Optional<AtomicFile> trace;
    private final Optional<AtomicFile> image;
    private final Optional<AtomicFile> journal;
    private final Optional<Writer> traceWriter;
    private Optional<Frame> lastFrame = Optional.empty();

    RunOutputs(RunOptions options) throws IOException {
        try {
            trace = openFile(options.trace());
            image = openFile(options.image());
            journal = openFile(options.journal());
        } catch (IOException e) {
            close();
            throw e;
        }
        traceWriter =
                trace.map(file -> new BufferedWriter(new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8)));
    }

    private Optional<AtomicFile> openFile(Optional<Path> path) throws IOException {
        if (path.isEmpty()) {
            return Optional.empty();
        }
        AtomicFile file = AtomicFile.create(path.get());
        openFiles.add(file);
        return Optional.of(file);
    }

    /** Returns the observers that must be called after every tick. */
    List<TickObserver> observers() {
        List<TickObserver> observers = new ArrayList<>();
        traceWriter.ifPresent(writer -> observers.add(new TraceWriter(writer)));
        if (image.isPresent()) {
            observers.add(this::recordLastFrame);
        }
        return observers;
    }

    private void recordLastFrame(Simulation simulation) {
        if (simulation.ticks() == simulation.setup().ticks()) {
            lastFrame = Optional.of(simulation.frame());
        }
    }

    /** Writes the remaining outputs and moves every file into place. */
    void finish(Scenario scenario, long ticks) throws IOException {
        if (traceWriter.isPresent()) {
            traceWriter.get().flush();
        }
        if (image.isPresent()) {
            PngImage.write(renderImage(lastFrame.orElseThrow()), image.get().stream());
        }
        if (journal.isPresent()) {
            Scenario replay = JournalScenario.create(scenario, new Journal(scenario.setup(), List.of(), ticks));
            journal.get().stream().write(replay.toBytes());
        }
        for (AtomicFile file : openFiles) {
            file.commit();
        }
    }

    private static BufferedImage renderImage(Frame frame) {
        double height =
                IMAGE_WIDTH * frame.snapshot().height() / frame.snapshot().width();
        return FrameRenderer.render(
                frame, Palette.LIGHT, IMAGE_WIDTH, (int) Math.max(MIN_HEIGHT, Math.min(MAX_HEIGHT, height)));
    }

    @Override
    public void close() throws IOException {
        IOException failure = null;
        for (AtomicFile file : openFiles) {
            try {
                file.close();
            } catch (IOException e) {
                failure = e;
            }
        }
        if (failure != null) {
            throw failure;
        }
    }
}
