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
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The output files of a run. All files are opened before the run, so that one that cannot be written is reported at
 * once, and moved into place after it; a failed run leaves no files.
 */
final class RunOutputs implements AutoCloseable {

    private static final int IMAGE_WIDTH = 1200;
    private static final int MIN_HEIGHT = 300;
    private static final int MAX_HEIGHT = 2400;

    private final Map<Output, AtomicFile> files = new EnumMap<>(Output.class);
    private Writer traceWriter = Writer.nullWriter();
    private Frame lastFrame;

    RunOutputs(RunOptions options) throws IOException {
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
    List<TickObserver> observers() {
        List<TickObserver> observers = new ArrayList<>();
        if (files.containsKey(Output.TRACE)) {
            traceWriter = new BufferedWriter(
                    new OutputStreamWriter(files.get(Output.TRACE).stream(), StandardCharsets.UTF_8));
            observers.add(new TraceWriter(traceWriter));
        }
        if (files.containsKey(Output.IMAGE)) {
            observers.add(this::recordLastFrame);
        }
        return observers;
    }

    private void recordLastFrame(Simulation simulation) {
        if (simulation.ticks() == simulation.setup().ticks()) {
            lastFrame = simulation.frame();
        }
    }

    /** Writes the remaining outputs and moves every file into place. */
    void finish(Scenario scenario, long ticks) throws IOException {
        traceWriter.flush();
        if (files.containsKey(Output.IMAGE)) {
            PngImage.write(renderImage(lastFrame), files.get(Output.IMAGE).stream());
        }
        if (files.containsKey(Output.JOURNAL)) {
            Scenario replay = JournalScenario.create(scenario, new Journal(scenario.setup(), List.of(), ticks));
            files.get(Output.JOURNAL).stream().write(replay.toBytes());
        }
        for (AtomicFile file : files.values()) {
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
