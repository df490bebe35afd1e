package faultline.app;

import faultline.app.RunOptions.Output;
import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.engine.metrics.TraceWriter;
import faultline.io.AtomicFile;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.PngImage;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.Palette;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.zip.Deflater;
import java.util.zip.GZIPOutputStream;

/**
 * The output files of a run. All files are opened before the run, so that one that cannot be written is reported at
 * once, and moved into place after it; a failed run leaves no files.
 */
final class RunOutputs implements AutoCloseable {

    private static final int IMAGE_WIDTH = 1200;

    /** Rows of a trace that are written at a time, if someone may watch a run at its pace. */
    private static final int MAX_PACED_ROWS = 25;

    /** Compresses several times as fast as the usual level, to a sixth more, so that a run hardly waits for it. */
    private static final class FastGzip extends GZIPOutputStream {

        FastGzip(OutputStream out) throws IOException {
            super(out);
            def.setLevel(Deflater.BEST_SPEED);
        }
    }

    private final Map<Output, AtomicFile> files = new EnumMap<>(Output.class);
    /** Null unless there is a trace. */
    private TraceWriter traceWriter;
    /** Null unless the trace is compressed. */
    private GZIPOutputStream traceEnd;

    private final String scenarioHash;
    private final RunOptions options;
    private final double pace;
    private Simulation simulation;
    private FilmRecorder film;
    private Frame lastFrame;
    private Journal journal;

    RunOutputs(RunOptions options) throws IOException {
        this.options = options;
        pace = options.pace();
        scenarioHash = options.outputs().containsKey(Output.TRACE_HEADER)
                ? TraceHeader.sha256(Files.readAllBytes(options.file()))
                : "";
        try {
            for (Map.Entry<Output, Path> output : options.outputs().entrySet()) {
                files.put(output.getKey(), AtomicFile.create(output.getValue()));
            }
        } catch (IOException e) {
            close();
            throw e;
        }
    }

    /** Returns the observers that must be called after every tick. */
    List<TickObserver> observers() throws IOException {
        List<TickObserver> observers = new ArrayList<>();
        if (files.containsKey(Output.TRACE)) {
            traceWriter = Double.isFinite(pace)
                    ? new TraceWriter(traceStream(), options.traceFormat(), MAX_PACED_ROWS)
                    : new TraceWriter(traceStream(), options.traceFormat());
            observers.add(traceWriter);
        }
        if (files.containsKey(Output.TRACE_HEADER)) {
            observers.add(traced -> simulation = traced);
        }
        if (files.containsKey(Output.FILM)) {
            film = new FilmRecorder(files.get(Output.FILM).stream());
            observers.add(film);
        }
        if (!files.containsKey(Output.FILM) && !files.containsKey(Output.IMAGE)) {
            observers.add(Simulation::stopRecordingPath);
        }
        if (files.containsKey(Output.IMAGE) || files.containsKey(Output.JOURNAL)) {
            observers.add(this::recordEnd);
        }
        if (Double.isFinite(pace)) {
            observers.add(new PaceKeeper(pace));
        }
        return observers;
    }

    /** Returns where the trace goes, compressed if its file is named so. */
    private OutputStream traceStream() throws IOException {
        OutputStream out = files.get(Output.TRACE).stream();
        if (options.outputs().get(Output.TRACE).toString().endsWith(".gz")) {
            traceEnd = new FastGzip(out);
            return traceEnd;
        }
        return out;
    }

    private void recordEnd(Simulation simulation) {
        if (simulation.ticks() == simulation.setup().ticks()) {
            lastFrame = simulation.frame();
            journal = simulation.journal();
        }
    }

    /** Writes the remaining outputs and moves every file into place. */
    void finish(Scenario scenario) throws IOException {
        if (traceWriter != null) {
            traceWriter.flush();
        }
        if (traceEnd != null) {
            traceEnd.finish();
        }
        if (files.containsKey(Output.TRACE_HEADER)) {
            String header = TraceHeader.text(scenario.name(), options, scenarioHash, simulation);
            files.get(Output.TRACE_HEADER).stream().write(header.getBytes(StandardCharsets.UTF_8));
        }
        if (files.containsKey(Output.IMAGE)) {
            writeImage(files.get(Output.IMAGE).stream());
        }
        if (files.containsKey(Output.JOURNAL)) {
            Scenario replay = JournalScenario.create(scenario, journal);
            files.get(Output.JOURNAL).stream().write(replay.toBytes());
        }
        if (film != null) {
            film.close();
        }
        AtomicFile.commitAll(files.values());
    }

    /** Writes the last frame, as a drawing if its file is named so. */
    private void writeImage(OutputStream out) throws IOException {
        RenderRequest picture = FrameRenderer.request(
                lastFrame, Palette.LIGHT, IMAGE_WIDTH, FrameRenderer.heightFor(lastFrame, IMAGE_WIDTH));
        if (options.outputs().get(Output.IMAGE).toString().endsWith(".svg")) {
            out.write(picture.toSvg().getBytes(StandardCharsets.UTF_8));
        } else {
            PngImage.write(picture.toImage(1), out);
        }
    }

    @Override
    public void close() throws IOException {
        if (traceWriter != null) {
            traceWriter.close();
        }
        IOException failure = null;
        for (AtomicFile file : files.values()) {
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
