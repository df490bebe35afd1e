package faultline.app;

import faultline.app.RunOptions.Output;
import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.engine.trace.TraceWriter;
import faultline.io.AtomicFile;
import faultline.io.AtomicFileGroup;
import faultline.io.MessageException;
import faultline.io.Sha256;
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
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
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

    private final RunOptions options;
    private final String scenarioHash;
    private final AtomicFileGroup files = new AtomicFileGroup();
    private final Map<Output, AtomicFile> opened = new EnumMap<>(Output.class);
    /** Null unless there is a trace. */
    private TraceWriter traceWriter;
    /** Null unless the trace is compressed. */
    private GZIPOutputStream traceEnd;
    /** Null unless there is a film. */
    private FilmRecorder film;

    // Set during the run, if an output needs them.
    private Simulation simulation;
    private Frame lastFrame;
    private Journal journal;

    RunOutputs(RunOptions options) throws IOException {
        this.options = options;
        scenarioHash = options.outputs().containsKey(Output.TRACE_HEADER)
                ? Sha256.hex(Files.readAllBytes(options.file()))
                : "";
        try {
            for (Map.Entry<Output, Path> output : options.outputs().entrySet()) {
                // A device or a pipe has no files beside it.
                if (output.getKey() != Output.TRACE_HEADER
                        || !opened.get(Output.TRACE).isStream()) {
                    opened.put(output.getKey(), files.create(output.getValue()));
                }
            }
        } catch (IOException e) {
            files.close();
            throw e;
        }
    }

    /** Returns the observers that must be called after every tick. */
    List<TickObserver> observers() throws IOException {
        List<TickObserver> observers = new ArrayList<>();
        if (opened.containsKey(Output.TRACE)) {
            traceWriter = Double.isFinite(options.pace())
                    ? new TraceWriter(traceStream(), options.traceFormat(), MAX_PACED_ROWS)
                    : new TraceWriter(traceStream(), options.traceFormat());
            observers.add(traceWriter);
        }
        if (opened.containsKey(Output.TRACE_HEADER)) {
            observers.add(traced -> simulation = traced);
        }
        if (opened.containsKey(Output.FILM)) {
            film = new FilmRecorder(stream(Output.FILM));
            observers.add(film);
        }
        if (!opened.containsKey(Output.FILM) && !opened.containsKey(Output.IMAGE)) {
            observers.add(Simulation::stopRecordingPath);
        }
        if (!opened.containsKey(Output.JOURNAL)) {
            observers.add(Simulation::stopRecordingDecisions);
        }
        if (opened.containsKey(Output.IMAGE) || opened.containsKey(Output.JOURNAL)) {
            observers.add(this::recordEnd);
        }
        if (Double.isFinite(options.pace())) {
            observers.add(new PaceKeeper(options.pace()));
        }
        return observers;
    }

    /** Returns where the trace goes, compressed if its file is named so. */
    private OutputStream traceStream() throws IOException {
        OutputStream out = stream(Output.TRACE);
        if (hasEnding(Output.TRACE, ".gz")) {
            traceEnd = new FastGzip(out);
            return traceEnd;
        }
        return out;
    }

    /** Returns whether the name of an output has an ending, in small letters or capitals. */
    private boolean hasEnding(Output output, String ending) {
        return options.outputs().get(output).toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }

    private void recordEnd(Simulation simulation) {
        if (simulation.ticks() == simulation.setup().ticks()) {
            lastFrame = simulation.frame();
            journal = simulation.journal();
        }
    }

    private OutputStream stream(Output output) {
        return opened.get(output).stream();
    }

    /**
     * Writes the remaining outputs and moves every file into place. Returns the line that reports why the journal is
     * not among them, if the run cannot be saved as a scenario; a journal of an earlier run is then deleted, because it
     * would seem to be of this one.
     */
    Optional<String> finish(Scenario scenario) throws IOException {
        if (traceWriter != null) {
            traceWriter.flush();
        }
        if (traceEnd != null) {
            traceEnd.finish();
        }
        if (opened.containsKey(Output.TRACE_HEADER)) {
            String header = TraceHeader.text(scenario.name(), options, scenarioHash, simulation);
            stream(Output.TRACE_HEADER).write(header.getBytes(StandardCharsets.UTF_8));
        }
        if (opened.containsKey(Output.IMAGE)) {
            writeImage(stream(Output.IMAGE));
        }
        Optional<String> unsaved = opened.containsKey(Output.JOURNAL) ? writeJournal(scenario) : Optional.empty();
        if (film != null) {
            film.close();
        }
        files.commit();
        return unsaved;
    }

    private Optional<String> writeJournal(Scenario scenario) throws IOException {
        byte[] replay;
        try {
            replay = JournalScenario.create(scenario, journal).toBytes();
        } catch (MessageException unsaved) {
            files.discard(opened.get(Output.JOURNAL));
            return Optional.of(CommandLine.problem(options.outputs().get(Output.JOURNAL), unsaved));
        }
        stream(Output.JOURNAL).write(replay);
        return Optional.empty();
    }

    /** Writes the last frame, as a drawing if its file is named so. */
    private void writeImage(OutputStream out) throws IOException {
        RenderRequest picture = FrameRenderer.request(
                lastFrame, Palette.LIGHT, IMAGE_WIDTH, FrameRenderer.heightFor(lastFrame, IMAGE_WIDTH));
        if (hasEnding(Output.IMAGE, ".svg")) {
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
        files.close();
    }
}
